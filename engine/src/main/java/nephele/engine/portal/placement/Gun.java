package nephele.engine.portal.placement;

import nephele.engine.level.PortalGun;
import nephele.engine.portal.Aperture;

/**
 * What is shot, and how far.
 *
 * @param rangeMetres a surface beyond is not reached
 * @param slideMetres a portal that does not fit where it was aimed at moves this far at most
 */
public record Gun(Aperture aperture, double rangeMetres, double slideMetres) {
    /** Of the aperture's height, but no more than half of it: what one aims at stays inside or next to the portal. */
    private static final double SLIDE_PER_HEIGHT = 0.75 / 2.1;

    public static Gun of(PortalGun said) {
        return new Gun(
                Aperture.of(said.shape(), said.widthMetres(), said.heightMetres()),
                said.rangeMetres(),
                SLIDE_PER_HEIGHT * said.heightMetres());
    }
}
