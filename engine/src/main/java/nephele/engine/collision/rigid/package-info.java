/**
 * Rigid bodies: boxes, spheres and capsules that fall, collide, stack, sleep and pass through portals. Deterministic
 * and single-threaded. {@link nephele.engine.collision.rigid.RigidStep} is the entry point.
 */
package nephele.engine.collision.rigid;
