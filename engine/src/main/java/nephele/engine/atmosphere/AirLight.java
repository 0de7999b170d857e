package nephele.engine.atmosphere;

import nephele.engine.math.Vec3;

/**
 * The effect of the air along a part of a ray on light at 680, 550 and 440 nm.
 *
 * @param radiance that the air adds, all orders of scattering, per unit solar irradiance outside the air, 1/sr
 * @param transmittance fraction of the light behind the part that passes
 */
public record AirLight(Vec3 radiance, Vec3 transmittance) {
    /** No air. */
    public static final AirLight NONE = new AirLight(Vec3.ZERO, new Vec3(1, 1, 1));
}
