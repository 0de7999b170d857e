/**
 * The narrow phase: contact manifolds of boxes, spheres and capsules with each other and with convex static shapes, by
 * separating axes and face clipping.
 */
package nephele.engine.collision.rigid.contact;
