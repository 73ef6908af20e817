// dotnet run --project . worked.jsonl
using System;
using System.IO;
using System.Numerics;
using System.Text.Json;

static class Reader
{
    static string Rational(JsonElement coordinate)
    {
        var parts = (coordinate.GetString() + "/1").Split('/');
        return $"{BigInteger.Parse(parts[0])}/{BigInteger.Parse(parts[1])}";
    }

    static void Main(string[] args)
    {
        foreach (var line in File.ReadLines(args[0]))
        {
            var c = JsonDocument.Parse(line).RootElement;
            var expected = c.GetProperty("expected");
            var loop = expected.GetProperty("trajectory");
            Console.WriteLine($"{c.GetProperty("id").GetString()} {c.GetProperty("directrix").GetArrayLength()} "
                + $"{loop.GetArrayLength()} {expected.GetProperty("exact_fits").GetArrayLength()} "
                + $"{Rational(loop[0][0])} {Rational(loop[0][1])}");
        }
    }
}
