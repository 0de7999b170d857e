package nephele.engine.render.pass.thing;

import java.util.Optional;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.SurfaceVariant;
import nephele.engine.render.frame.ThingMeshes.RunUniforms;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.ShaderSource;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.ViewTree;

/**
 * Which code a group's shader holds; equal variants share a program. What has no texture is given details – except in
 * output PLAIN, which shows values as stored.
 */
record ThingVariant(SurfaceVariant surface, boolean detailed, ThingLook look) {
    private static final String FOLDER = "/nephele/engine/render/pass/thing/";

    static ThingVariant of(SolidBatch.Kind kind, Output output, ThingLook look) {
        boolean bare = !kind.isTextured() && !kind.isNormalMapped();
        return new ThingVariant(SurfaceVariant.of(kind), bare && output != Output.PLAIN, look);
    }

    GlProgram<ThingUniforms> program(LoadContext context, int materialsPerBlock) {
        SurfaceLight light = context.shared().surfaceLight();
        Defines defines = surface.addTo(light.addForThings(Defines.of(context)), materialsPerBlock)
                .withIf(detailed, "DETAIL");
        if (look == ThingLook.SEE_THROUGH) {
            defines.with("SEE_THROUGH").with("FACE_OPACITY", ThingPass.HELD_FACE_OPACITY);
        }
        return new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "thing.vert", defines.values()),
                ShaderSource.load(FOLDER + "thing.frag", defines.values()),
                uniforms -> uniforms(
                        uniforms, light, ViewTree.mayGrow(context.scene().level())));
    }

    private ThingUniforms uniforms(Uniforms uniforms, SurfaceLight light, boolean cut) {
        surface.set(uniforms);
        light.tieForThings(uniforms);
        return new ThingUniforms(
                uniforms.vector3("eyeHigh"),
                uniforms.vector3("eyeLow"),
                cut ? Optional.of(uniforms.scalar("seamPerMetre")) : Optional.empty(),
                look == ThingLook.SEE_THROUGH ? Optional.of(uniforms.scalar("clarity")) : Optional.empty(),
                RunUniforms.of(uniforms));
    }
}
