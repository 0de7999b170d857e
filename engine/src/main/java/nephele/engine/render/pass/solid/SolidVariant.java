package nephele.engine.render.pass.solid;

import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.SurfaceVariant;
import nephele.engine.scene.SolidBatch;

/**
 * The code of a batch's shader; equal variants share a program.
 *
 * @param emission true if any material emits light
 */
record SolidVariant(SolidBatch.Form form, SurfaceVariant surface, boolean emission) {
    private static final String FOLDER = "/nephele/engine/render/pass/solid/";

    static SolidVariant of(SolidBatch batch, Level level, Quality quality) {
        boolean emission =
                level.materials().stream().anyMatch(m -> !m.emission().equals(Vec3.ZERO));
        SurfaceVariant surface = SurfaceVariant.of(batch.kind(), quality);
        boolean isPlain = batch.form() == SolidBatch.Form.TURNED_SOLID && !surface.normalMapped();
        return new SolidVariant(isPlain ? SolidBatch.Form.SOLID : batch.form(), surface, emission);
    }

    GlProgram<SolidUniforms> program(LoadContext context, int materialsPerBlock) {
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        Defines lit = form.isModel() ? light.addForModels(Defines.of(context)) : light.addTo(Defines.of(context));
        var defines = surface.addTo(lit, materialsPerBlock)
                .withIf(emission, "EMISSION")
                .withIf(form.isModel(), "MODEL")
                .withIf(form == SolidBatch.Form.CURVED_MODEL, "CURVED_RECEIVER")
                .withIf(form == SolidBatch.Form.TURNED_SOLID, "TURNED_TEXTURE")
                .withIf(isLitPerFace(light), "FLAT_LIGHT")
                .values();
        return GlProgram.of(context.gl(), FOLDER + "solid.vert", FOLDER + "solid.frag", defines, SolidUniforms.class);
    }

    /** Returns true if light cannot vary over a face. */
    private boolean isLitPerFace(SurfaceLight light) {
        return !form.isModel() && surface.isLambert() && !surface.normalMapped() && !light.variesOverFaces();
    }
}
