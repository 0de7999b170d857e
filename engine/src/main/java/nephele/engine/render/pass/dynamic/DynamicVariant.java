package nephele.engine.render.pass.dynamic;

import java.util.Optional;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.SurfaceVariant;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.DynamicMeshes.RunUniforms;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.ViewTree;

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
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "dynamic.vert", defines.values()),
                ShaderSource.load(FOLDER + "dynamic.frag", defines.values()),
                uniforms -> uniforms(
                        uniforms, light, ViewTree.mayGrow(context.scene().level())));
    }

    private DynamicUniforms uniforms(Uniforms uniforms, SurfaceLight light, boolean cut) {
        surface.set(uniforms);
        light.tieForDynamicObjects(uniforms);
        return new DynamicUniforms(
                uniforms.vector3("eyeHigh"),
                uniforms.vector3("eyeLow"),
                cut ? Optional.of(uniforms.scalar("seamPerMetre")) : Optional.empty(),
                look == DynamicBlending.SEE_THROUGH ? Optional.of(uniforms.scalar("clarity")) : Optional.empty(),
                RunUniforms.of(uniforms));
    }
}
