// go run reader.go worked.jsonl
package main

import (
	"encoding/json"
	"fmt"
	"io"
	"math/big"
	"os"
)

type Case struct {
	ID        string
	Directrix [][2]string
	Expected  struct {
		Trajectory [][2]*big.Rat        // "-7/2" is read exactly
		Fits       [][2][2]*big.Rat `json:"exact_fits"`
	}
}

func main() {
	file, _ := os.Open(os.Args[1])
	lines := json.NewDecoder(file)
	for c := (Case{}); lines.Decode(&c) != io.EOF; c = (Case{}) {
		t := c.Expected.Trajectory
		fmt.Println(c.ID, len(c.Directrix), len(t), len(c.Expected.Fits), t[0][0], t[0][1])
	}
}
