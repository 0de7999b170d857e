/**
 * Rigid bodies: boxes, spheres and capsules that fall, collide, stack, sleep and pass through portals. Deterministic
 * and single-threaded. {@link nephele.engine.collision.rigid.RigidStep} is the entry point. At an aperture a body
 * collides with the static world as {@link nephele.engine.collision.PortalWorld#openedFor} cuts it; {@link
 * nephele.engine.collision.rigid.PortalContacts#keepValid} drops its contact points with other bodies beyond it.
 */
package nephele.engine.collision.rigid;
