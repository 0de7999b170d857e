/** Solutions of the game's levels, played by code and kept as replays beside the levels. */
package nephele.lab.solve;
