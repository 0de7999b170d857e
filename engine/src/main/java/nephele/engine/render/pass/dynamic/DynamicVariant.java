package nephele.engine.render.pass.dynamic;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.SurfaceVariant;
import nephele.engine.scene.SolidBatch;

/**
 * The code of a group's shader; equal variants share a program. Surfaces without texture receive procedural details,
 * except in output PLAIN, which shows values as stored.
 */
record DynamicVariant(SurfaceVariant surface, boolean detailed, DynamicBlending look) {
    private static final String FOLDER = "/nephele/engine/render/pass/dynamic/";

    static DynamicVariant of(SolidBatch.Kind kind, LoadContext context, DynamicBlending look) {
        boolean bare = !kind.isTextured() && !kind.isNormalMapped();
        return new DynamicVariant(
                SurfaceVariant.of(kind, context.quality()), bare && context.output() != Output.PLAIN, look);
    }

    GlProgram<DynamicUniforms> program(LoadContext context, int materialsPerBlock) {
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        Defines defines = surface.addTo(light.addForDynamicObjects(Defines.of(context)), materialsPerBlock)
                .withIf(detailed, "DETAIL");
        if (look == DynamicBlending.SEE_THROUGH) {
            defines.with("SEE_THROUGH").with("FACE_OPACITY", DynamicPass.HELD_FACE_OPACITY);
        }
        return GlProgram.of(
                context.gl(),
                FOLDER + "dynamic.vert",
                FOLDER + "dynamic.frag",
                defines.values(),
                DynamicUniforms.class);
    }
}
