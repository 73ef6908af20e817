(* Reads claims as plain numbers, as exactsweep.check.claims writes them, and prints the answer of the
   extracted checker to each. *)
open Checker
module B = Big_int_Z

let scan = ref (Scanf.Scanning.from_string "")
let token () = Scanf.bscanf !scan " %s" Fun.id
let read s = if s = "" then failwith "no number" else B.big_int_of_string s      (* zarith reads "" as 0 *)
let integer () = read (token ())
let positive s = let n = read s in if B.sign_big_int n > 0 then n else failwith "not positive"
let nat () = let n = int_of_string (token ()) in if n >= 0 then n else failwith "negative"
let list f = List.init (nat ()) (fun _ -> f ())      (* List.init goes from the first on *)
let flag () = match nat () with 0 -> false | 1 -> true | _ -> failwith "neither 0 nor 1"
let option f = if flag () then Some (f ()) else None
let pair f g = let a = f () in let b = g () in (a, b)
let rational () =
  match String.split_on_char '/' (token ()) with
  | [n; d] -> { qnum = read n; qden = positive d }
  | _ -> failwith "not a fraction"
let point () = pair integer integer
let rational_point () = pair rational rational
let ring () = list point
let rational_ring () = list rational_point
let segment () = pair rational_point rational_point
let sums () = list (fun () -> pair nat (fun () -> list (fun () -> list integer)))
let quadruple () = let a = integer () in let b = integer () in let c = integer () in let d = integer () in (((a, b), c), d)

let no_fit_certificate () =
  let unit0 = positive (token ()) in let still = list ring in let moving = list ring in let listed_sums = sums () in
  { unit0; still; moving; listed_sums }
let sweep_certificate () =
  let unit2 = positive (token ()) in let moving0 = list ring in let listed_sums1 = sums () in { unit2; moving0; listed_sums1 }
let inner_fit_certificate () =
  let unit1 = positive (token ()) in let box = quadruple () in let outside = list ring in let part0 = list ring in
  let listed_sums0 = sums () in let around = list (fun () -> list integer) in
  { unit1; box; outside; part0; listed_sums0; around }

let figure () =
  let outline = list rational_ring in let rounded = list (fun () -> pair rational_ring rational) in
  let error = rational () in { outline; rounded; error }
let triangles () = pair (fun () -> list ring) (fun () -> list (fun () -> list ring))

let part () =
  let form = figure () in let demand = option nat in let rotations = option (fun () -> list rational_point) in
  let mirrored_rotations = option (fun () -> list rational_point) in
  let may_mirror = flag () in { form; demand; rotations; mirrored_rotations; may_mirror }
let placement () =
  let kind = nat () in let mirrored = flag () in let cosine = rational () in let sine = rational () in
  let shift = rational_point () in let slack = rational () in
  { kind; by_motion = { mirrored; cosine; sine; shift }; slack }
let layout () =
  let sheet = option figure in let obstacles = list (fun () -> pair figure rational) in let kinds = list part in let placements = list placement in
  let spacing = rational () in let margin = rational () in { sheet; obstacles; kinds; placements; spacing; margin }
let certificate () =
  let denominator = positive (token ()) in let part_pieces = list (fun () -> list ring) in
  let kind_pieces = list (fun () -> list ring) in let obstacle_pieces = list (fun () -> list ring) in
  let outside_pieces = list ring in let frame = quadruple () in
  { denominator; part_pieces; kind_pieces; obstacle_pieces; outside_pieces; frame }
let body () = match nat () with 0 -> Part (nat ()) | 1 -> Beyond | 2 -> Obstacle (nat ()) | _ -> failwith "no body"
let fault () = match nat () with
  | 0 -> Missing (nat ()) | 1 -> Surplus (nat ()) | 2 -> Mirrored (nat ()) | 3 -> Rotated (nat ()) | 4 -> Not_simple (nat ())
  | 5 -> let i = nat () in Overlapping (i, body ())
  | 6 -> let i = nat () in Too_close (i, body ())
  | _ -> failwith "no fault"
(* Normals are hints: whatever this table gives, the theorem holds. *)
let normals () =
  let table = Hashtbl.create 1000 in
  ignore (list (fun () -> let (((a, i), b), j) = quadruple () in
    let int = B.int_of_big_int in Hashtbl.replace table (int a, int i, int b, int j) (point ())));
  fun a i b j -> match Hashtbl.find_opt table (a, i, b, j) with
    | Some n -> n
    | None -> (match Hashtbl.find_opt table (a, -1, b, -1) with Some n -> n | None -> (B.zero_big_int, B.zero_big_int))

let answer = function
  | "no_fit" ->
    let d = list rational_ring in let g = list rational_ring in let exterior = rational_ring () in let holes = list rational_ring in
    let fits = list segment in let c = no_fit_certificate () in check_no_fit_polygon d g exterior holes fits c (triangles ())
  | "inner_fit" ->
    let c = list rational_ring in let g = list rational_ring in
    let regions = list (fun () -> pair rational_ring (fun () -> list rational_ring)) in let fits = list segment in
    let e = inner_fit_certificate () in check_inner_fit_polygon c g regions fits e (list triangles)
  | "sweep" ->
    let d = list rational_ring in let g = list rational_ring in let exterior = rational_ring () in let holes = list rational_ring in
    let fits = list segment in let outer = rational_ring () in let inner = rational_ring () in let unswept = list rational_ring in
    let slits = list segment in let area = rational () in let c = no_fit_certificate () in let t = triangles () in
    let c' = sweep_certificate () in let t' = triangles () in
    check_whole_sweep d g exterior holes fits outer inner unswept slits area c t c' t' (rational_point ())
  | "sum" ->
    let g = list rational_ring in let path = rational_ring () in let exterior = rational_ring () in let holes = list rational_ring in
    let slits = list segment in let c = sweep_certificate () in check_path_sum g path exterior holes slits c (triangles ())
  | "layout" ->
    let l = layout () in let c = certificate () in let n = normals () in
    check_layout n (fun a i b j -> n (B.int_of_big_int a) i b j) l c
  | "faults" -> let l = layout () in let fs = list fault in check_faults l fs (list segment)
  | word -> failwith ("unknown claim " ^ word)

(* One claim a line; a line that is none is an error of the program that writes it. *)
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
