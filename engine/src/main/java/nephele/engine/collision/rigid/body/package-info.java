/**
 * The state of rigid bodies: positions, velocities, mass and inertia, the portals that a body reaches through, and the
 * cached contacts of the last tick.
 */
package nephele.engine.collision.rigid.body;
