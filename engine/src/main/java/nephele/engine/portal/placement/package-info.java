/**
 * Decides where a portal fits. {@link nephele.engine.portal.placement.Placement} merges the coplanar faces around a
 * shot's hit into regions of a plane and finds the nearest place in them where the whole aperture fits.
 */
package nephele.engine.portal.placement;
