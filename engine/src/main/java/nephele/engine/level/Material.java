package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A metallic-roughness material. One that sets only colour or texture is Lambertian: {@code roughness} and {@code
 * metallic} are {@code null}.
 *
 * @param baseColour linear RGB, multiplies the texture
 * @param texture asset id of an sRGB picture, or {@code null}
 * @param roughness perceptual roughness 0–1 (α = roughness²), or {@code null} for Lambert
 * @param metallic 0–1, or {@code null} for 0
 * @param normalTexture asset id of a tangent-space normal map (RGB; alpha multiplies roughness), or {@code null}
 * @param emission linear RGB radiance
 * @param textureMetres side of the square that one repeat of the texture covers
 * @param mirror true if flat faces of solids are plane mirrors that reflect {@code baseColour} of the light
 */
public record Material(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(absent = "[1, 1, 1]") @Range(min = 0, max = 1) Vec3 baseColour,
        @Written(text = TextKind.ASSET) String texture,
        @Written @Range(min = 0, max = 1) Double roughness,
        @Written @Range(min = 0, max = 1) Double metallic,
        @Written(text = TextKind.ASSET) String normalTexture,
        @Written(absent = "[0, 0, 0]") @Range(min = 0, max = 1e9) Vec3 emission,
        @Written(absent = "1") @Range(min = 1e-3) double textureMetres,
        @Written boolean mirror) {
    /** Creates a material that is no mirror. */
    public Material(
            String id,
            Vec3 baseColour,
            String texture,
            Double roughness,
            Double metallic,
            String normalTexture,
            Vec3 emission,
            double textureMetres) {
        this(id, baseColour, texture, roughness, metallic, normalTexture, emission, textureMetres, false);
    }

    /** The material of faces that name none. */
    public static final Material DEFAULT_GREY =
            new Material("", new Vec3(0.5, 0.5, 0.5), null, null, null, null, Vec3.ZERO, 1);

    /** Returns true if the material needs no view-dependent term. */
    public boolean lambert() {
        return roughness == null && metallic == null;
    }
}
