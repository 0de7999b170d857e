/** The static world as convex solids, and moving rounded shapes against it: distance, sweep, ray. Allocates nothing per query. */
package nephele.engine.collision;
