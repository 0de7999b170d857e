package nephele.engine.portal.placement;

import nephele.engine.level.PortalGun;
import nephele.engine.portal.Aperture;

/**
 * The aperture and range of a gun.
 *
 * @param rangeMetres greatest distance of a surface
 * @param slideMetres greatest distance that a portal moves from its aimed place to fit
 * @param toFloor true if its portals may slide down to floors, with an aid of shots
 */
public record Gun(Aperture aperture, double rangeMetres, double slideMetres, boolean toFloor) {
    /**
     * Slide relative to the aperture's height, at most half of it, so that the aimed point stays inside or next to the
     * portal.
     */
    private static final double SLIDE_PER_HEIGHT = 0.75 / 2.1;

    /** Creates a gun whose portals may slide down to floors. */
    public Gun(Aperture aperture, double rangeMetres, double slideMetres) {
        this(aperture, rangeMetres, slideMetres, true);
    }

    public static Gun of(PortalGun authored) {
        return new Gun(
                Aperture.of(authored.shape(), authored.widthMetres(), authored.heightMetres()),
                authored.rangeMetres(),
                SLIDE_PER_HEIGHT * authored.heightMetres(),
                authored.toFloor());
    }
}
