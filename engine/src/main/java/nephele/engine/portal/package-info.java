/**
 * Portals, independent of rendering and physics. A {@link nephele.engine.portal.PortalTransform} is the rigid map from
 * one portal's space to the space behind it; everything that goes through a portal is mapped by it. A {@link
 * nephele.engine.portal.PathTrace} follows a segment through apertures, a {@link nephele.engine.portal.PortalCrossing}
 * is one point where it goes through, and a {@link nephele.engine.portal.CrossingWord} is the reduced sequence of
 * portals between two places. The player goes through in {@code sim.player.PlayerMotion}, bodies in {@code
 * collision.rigid.body.BodyPortalState}.
 */
package nephele.engine.portal;
