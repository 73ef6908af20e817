(* Read claims as the plain numbers written by exactsweep.theorem.claims, and print the answer of the extracted checker
   to each. *)
open Checker
module B = Big_int_Z

let scan = ref (Scanf.Scanning.from_string "")
let token () = Scanf.bscanf !scan " %s" Fun.id
let read s = if s = "" then failwith "no number" else B.big_int_of_string s      (* zarith reads "" as 0 *)
let integer () = read (token ())
let positive s = let n = read s in if B.sign_big_int n > 0 then n else failwith "not positive"
let nat () = let n = int_of_string (token ()) in if n >= 0 then n else failwith "negative"
let natural () = let n = integer () in if B.sign_big_int n >= 0 then n else failwith "negative"
let list f = List.init (nat ()) (fun _ -> f ())      (* List.init evaluates in order *)
let flag () = match nat () with 0 -> false | 1 -> true | _ -> failwith "neither 0 nor 1"
let option f = if flag () then Some (f ()) else None
let pair f g = let a = f () in let b = g () in (a, b)
let rational () =
  match String.split_on_char '/' (token ()) with
  | [n; d] -> { qnum = read n; qden = positive d }
  | _ -> failwith "not a fraction"
let point () = pair rational rational
let ring () = list point
let rings () = list ring
let segments () = list (fun () -> pair point point)
let chains () = list (fun () -> list integer)
let sums () = list (fun () -> pair integer chains)
let cut () = pair rings (fun () -> list rings)
let four f = let a = f () in let b = f () in let c = f () in let d = f () in (((a, b), c), d)

let figure () =
  let outline = rings () in let rounded = list (fun () -> pair ring rational) in let error = rational () in { outline; rounded; error }
let rotation () = match nat () with
  | 0 -> let c = rational () in Rational (c, rational ())
  | 1 -> Degrees (rational ())
  | _ -> failwith "no rotation"
let part () =
  let form = figure () in let demand = option natural in let rotations = option (fun () -> list rotation) in
  let mirrored_rotations = option (fun () -> list rotation) in let may_mirror = flag () in
  { form; demand; rotations; mirrored_rotations; may_mirror }
let placement () =
  let kind = nat () in let mirrored = flag () in let cosine = rational () in let sine = rational () in let shift = point () in
  let degrees = option rational in let slack = rational () in
  { kind; by_motion = { mirrored; cosine; sine; shift }; degrees; slack }
let layout () =
  let sheet = option figure in let obstacles = list (fun () -> pair figure rational) in let kinds = list part in
  let placements = list placement in let spacing = rational () in let margin = rational () in
  { sheet; obstacles; kinds; placements; spacing; margin }
let body () = match nat () with 0 -> Part (nat ()) | 1 -> Beyond | 2 -> Obstacle (nat ()) | _ -> failwith "no body"
let fault () = match nat () with
  | 0 -> Missing (nat ()) | 1 -> Surplus (nat ()) | 2 -> Mirrored (nat ()) | 3 -> Rotated (nat ()) | 4 -> Not_simple (nat ())
  | 5 -> let i = nat () in Overlapping (i, body ())
  | 6 -> let i = nat () in Too_close (i, body ())
  | _ -> failwith "no fault"
(* Normals are hints: the theorem holds for any table. *)
let normals () =
  let table = Hashtbl.create 1000 in
  let int = B.int_of_big_int in
  ignore (list (fun () -> let (((a, i), b), j) = four integer in
    Hashtbl.replace table (int a, int i, int b, int j) (whole (point ()))));
  fun a i b j -> let a = int a in match Hashtbl.find_opt table (a, i, b, j) with
    | Some n -> n
    | None -> (match Hashtbl.find_opt table (a, -1, b, -1) with Some n -> n | None -> (B.zero_big_int, B.zero_big_int))

let answer = function
  | "no_fit" ->
    let d = rings () in let g = rings () in let exterior = ring () in let holes = rings () in let fits = segments () in
    let still = rings () in let moving = rings () in let listed = sums () in
    accept_no_fit d g exterior holes fits still moving listed (cut ())
  | "inner_fit" ->
    let c = rings () in let g = rings () in let regions = list (fun () -> pair ring rings) in let fits = segments () in
    let frame = four rational in let outside = rings () in let part = rings () in let listed = sums () in let around = chains () in
    accept_inner_fit c g regions fits frame outside part listed around (list cut)
  | "sweep" ->
    let d = rings () in let g = rings () in let exterior = ring () in let holes = rings () in let fits = segments () in
    let outer = ring () in let inner = ring () in let unswept = rings () in let slits = segments () in let area = rational () in
    let still = rings () in let moving = rings () in let listed = sums () in let t = cut () in let swept = sums () in
    accept_sweep d g exterior holes fits outer inner unswept slits area still moving listed t swept (cut ())
  | "sum" ->
    let g = rings () in let path = ring () in let exterior = ring () in let holes = rings () in let slits = segments () in
    let moving = rings () in let listed = sums () in
    accept_sum g path exterior holes slits moving listed (cut ())
  | "layout" ->
    let l = layout () in let pieces = list rings in let frame = four rational in
    accept_by (normals ()) l pieces frame
  | "faults" -> let l = layout () in let fs = list fault in accept_faults l fs (ring ())
  | word -> failwith ("unknown claim " ^ word)

(* One claim per line; an unreadable line is an error of the program that writes it. *)
let () =
  try
    while true do
      scan := Scanf.Scanning.from_string (read_line ());
      let found () = let is_accepted = answer (token ()) in if token () = "" then is_accepted else failwith "words after the claim" in
      print_endline (match found () with
        | true -> "accepted"
        | false -> "rejected"
        | exception (Failure _ | Invalid_argument _ | Scanf.Scan_failure _ | End_of_file) -> "unreadable")
    done
  with End_of_file -> ()
