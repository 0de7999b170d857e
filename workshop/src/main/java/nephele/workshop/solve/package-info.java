/** Scripted solutions of the game's levels; their replays are kept beside the levels. */
package nephele.workshop.solve;
