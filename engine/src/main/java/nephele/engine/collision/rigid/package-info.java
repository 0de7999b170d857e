/** Rigid bodies: boxes, spheres and capsules that fall, collide, stack, sleep and pass portals; deterministic, one thread. */
package nephele.engine.collision.rigid;
