package nephele.engine.scene.dynamic;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The light of the portal gun's own lamps on it; the exact twin of {@code gun-light.glsl}. Positions are the gun's own. */
public final class GunLight {
    private static final double HALF_CHAMBER_METRES = 0.03;

    private GunLight() {}

    /** Returns the fraction of the lamps' light at a place with this unit normal. */
    public static double ofLamps(Vector3dc place, Vector3dc normal) {
        double along = Math.max(
                GunMesh.CHAMBER.z() - HALF_CHAMBER_METRES,
                Math.min(GunMesh.CHAMBER.z() + HALF_CHAMBER_METRES, place.z()));
        Vector3d chamber = new Vector3d(GunMesh.CHAMBER.x(), GunMesh.CHAMBER.y(), along);
        Vector3d out = new Vector3d(
                place.x() / GunMesh.HOOP_HALF_WIDTH_METRES,
                (place.y() - GunMesh.HOOP.y()) / GunMesh.HOOP_HALF_HEIGHT_METRES,
                0);
        out.div(Math.max(out.length(), 1e-5));
        Vector3d hoop = GunMesh.HOOP
                .toVector()
                .add(GunMesh.HOOP_HALF_WIDTH_METRES * out.x, GunMesh.HOOP_HALF_HEIGHT_METRES * out.y, 0);
        return light(place, normal, chamber, GunMesh.LAMP_REACH_METRES)
                + light(place, normal, hoop, GunMesh.LAMP_REACH_METRES);
    }

    /** Returns the fraction of the light of a shot's flash. */
    public static double ofFlash(Vector3dc place, Vector3dc normal) {
        return light(place, normal, GunMesh.HOOP.toVector(), GunMesh.FLASH_REACH_METRES);
    }

    private static double light(Vector3dc place, Vector3dc normal, Vector3dc lamp, double reach) {
        Vector3d towards = new Vector3d(lamp).sub(place);
        double square = towards.lengthSquared();
        double facing = normal.dot(towards) / Math.sqrt(Math.max(square, 1e-10));
        return Math.max(0, facing * (1 - GunMesh.WRAPPED) + GunMesh.WRAPPED) * reach * reach / (square + reach * reach);
    }
}
