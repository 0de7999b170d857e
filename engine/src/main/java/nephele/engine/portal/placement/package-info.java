/** Where a portal fits: surfaces as regions of a plane, and the nearest place in one where an aperture is whole. */
package nephele.engine.portal.placement;
