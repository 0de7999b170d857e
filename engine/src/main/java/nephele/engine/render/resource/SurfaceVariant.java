package nephele.engine.render.resource;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.NormalMaps;
import nephele.engine.render.frame.Quality.ReflectionModel;
import nephele.engine.scene.SolidBatch;

/** The variant of the material code in a shader, for solids or dynamic objects. */
public record SurfaceVariant(Reflection reflection, boolean textured, boolean normalMapped) {
    /** The reflection that is compiled. */
    private enum Reflection {
        /** All materials of the batch are Lambertian. */
        LAMBERT,
        /** Quality replaces the specular lobe by diffuse light. */
        ALL_DIFFUSE,
        METALLIC_ROUGHNESS;

        static Reflection of(SolidBatch.Kind kind, Quality quality) {
            if (kind.lambert()) {
                return LAMBERT;
            }
            return quality.brdf() == ReflectionModel.LAMBERT ? ALL_DIFFUSE : METALLIC_ROUGHNESS;
        }
    }

    public static SurfaceVariant of(SolidBatch.Kind kind, Quality quality) {
        return new SurfaceVariant(
                Reflection.of(kind, quality),
                kind.isTextured(),
                kind.isNormalMapped() && quality.normalMaps() == NormalMaps.ON);
    }

    /** Returns true if the reflected light is the base colour times a factor that depends on the normal alone. */
    public boolean isLambert() {
        return reflection == Reflection.LAMBERT;
    }

    /**
     * Adds the defines.
     *
     * @param materialsPerBlock length of the array of materials
     */
    public Defines addTo(Defines defines, int materialsPerBlock) {
        return defines.with("MATERIAL_COUNT", materialsPerBlock)
                .with(reflection.name())
                .withIf(textured, "TEXTURED")
                .withIf(normalMapped, "NORMAL_MAP");
    }
}
