package nephele.engine.render.pass.impostor;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.EyeUniforms;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.View;
import nephele.engine.scene.impostor.ImpostorAtlas;

/** The shaders of plants: of impostors, or of meshes with or without a texture. */
final class PlantProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/impostor/";
    /** Sharper than one texel a pixel: the blend of three views blurs. */
    private static final double LOD_BIAS = -0.5;

    private record Numbers(
            EyeUniforms eye,
            @IfRead Uniforms.Scalar pixelsPerRadian,
            @IfRead Uniforms.Vector4 baseColour,
            @IfRead Uniforms.Scalar pictureLayer) {}

    private final GlProgram<Numbers> program;
    private final Vec3 anchor;

    static PlantProgram ofImpostors(LoadContext context) {
        return new PlantProgram(context, "impostor", false);
    }

    static PlantProgram ofMeshes(LoadContext context, boolean areTextured) {
        return new PlantProgram(context, "plant", areTextured);
    }

    private PlantProgram(LoadContext context, String file, boolean isTextured) {
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        anchor = light.anchor();
        MeteredExposure.readInViews(context);
        double pixels = context.quality().impostorPixels();
        var defines = light.addBounced(light.addForDynamicObjects(Defines.of(context)))
                .with("LAMBERT")
                .with("PER_SHEET", BillboardList.PER_SHEET)
                .with("IMPOSTOR_PIXELS", pixels)
                .with("VIEW_TEXELS", (double) ImpostorAtlas.texelsFor(pixels))
                .with("LOD_BIAS", LOD_BIAS)
                .withIf(pixels == 0, "ALWAYS_MESHES")
                .withIf(isTextured, "TEXTURED")
                .values();
        program = GlProgram.of(context.gl(), FOLDER + file + ".vert", FOLDER + file + ".frag", defines, Numbers.class);
    }

    void use(View view, double pixelsPerRadian) {
        program.use();
        program.uniforms().eye().set(view, anchor);
        program.uniforms().pixelsPerRadian().set(pixelsPerRadian);
    }

    /** Sets the material of the meshes that are drawn next. @param lobe light that is reflected diffusely */
    void material(Surface surface, double lobe) {
        program.uniforms().baseColour().set(surface.material().baseColour(), lobe);
        program.uniforms().pictureLayer().set(surface.colour().layer());
    }
}
