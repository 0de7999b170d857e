/**
 * The player's hands: picking up, holding and throwing a body, also through portals, and shooting portals. Decides
 * which obstacles end a hold and what happens to bodies and players in a portal that closes.
 */
package nephele.engine.sim.carry;
