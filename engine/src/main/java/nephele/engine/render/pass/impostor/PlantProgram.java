package nephele.engine.render.pass.impostor;

import java.util.Optional;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.View;
import nephele.engine.scene.impostor.ImpostorAtlas;

/** The shaders of plants: of impostors, or of meshes with or without a texture. */
final class PlantProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/impostor/";
    /** Sharper than one texel a pixel: the blend of three views blurs. */
    private static final double LOD_BIAS = -0.5;

    /** What a program draws. */
    enum Kind {
        IMPOSTOR("impostor"),
        BARE_MESH("plant"),
        TEXTURED_MESH("plant");

        private final String file;

        Kind(String file) {
            this.file = file;
        }
    }

    private record Numbers(
            Uniforms.Vector3 high,
            Uniforms.Vector3 low,
            Optional<Uniforms.Scalar> pixelsPerRadian,
            Optional<Uniforms.Vector4> baseColour,
            Optional<Uniforms.Scalar> pictureLayer) {}

    private final GlProgram<Numbers> program;
    private final Vec3 anchor;
    private final float[] eye = new float[6];

    PlantProgram(LoadContext context, Kind kind) {
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        anchor = light.anchor();
        double pixels = context.quality().impostorPixels();
        var defines = light.addForDynamicObjects(Defines.of(context))
                .with("LAMBERT")
                .with("PER_SHEET", BillboardList.PER_SHEET)
                .with("IMPOSTOR_PIXELS", pixels)
                .with("VIEW_TEXELS", (double) ImpostorAtlas.texelsFor(pixels))
                .with("LOD_BIAS", LOD_BIAS)
                .withIf(pixels == 0, "ALWAYS_MESHES")
                .withIf(kind == Kind.TEXTURED_MESH, "TEXTURED")
                .values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + kind.file + ".vert", defines),
                ShaderSource.load(FOLDER + kind.file + ".frag", defines),
                uniforms -> numbers(context, kind, uniforms));
    }

    private static Numbers numbers(LoadContext context, Kind kind, Uniforms uniforms) {
        MeteredExposure.tieInView(context, uniforms);
        context.get(SurfaceLight.RESOURCE).tieForDynamicObjects(uniforms);
        uniforms.sampler("plants", TextureUnit.PLANTS);
        uniforms.sampler("plantKinds", TextureUnit.PLANT_KINDS);
        uniforms.sampler("plantOrder", TextureUnit.PLANT_ORDER);
        boolean isImpostor = kind == Kind.IMPOSTOR;
        if (isImpostor) {
            uniforms.sampler("impostorColours", TextureUnit.COLOURS);
            uniforms.sampler("impostorShapes", TextureUnit.IMPOSTOR_SHAPES);
        } else if (kind == Kind.TEXTURED_MESH) {
            uniforms.sampler("colours", TextureUnit.COLOURS);
        }
        return new Numbers(
                uniforms.vector3("eyeHigh"),
                uniforms.vector3("eyeLow"),
                context.quality().impostorPixels() > 0
                        ? Optional.of(uniforms.scalar("pixelsPerRadian"))
                        : Optional.empty(),
                isImpostor ? Optional.empty() : Optional.of(uniforms.vector4("baseColour")),
                kind == Kind.TEXTURED_MESH ? Optional.of(uniforms.scalar("pictureLayer")) : Optional.empty());
    }

    void use(View view, double pixelsPerRadian) {
        program.use();
        SolidMesh.eyeInCell(view, anchor, eye);
        program.uniforms().high().set(eye[0], eye[1], eye[2]);
        program.uniforms().low().set(eye[3], eye[4], eye[5]);
        program.uniforms().pixelsPerRadian().ifPresent(uniform -> uniform.set((float) pixelsPerRadian));
    }

    /** Sets the material of the meshes that are drawn next. @param lobe light that is reflected diffusely */
    void material(Surface surface, double lobe) {
        Vec3 colour = surface.material().baseColour();
        program.uniforms()
                .baseColour()
                .ifPresent(uniform ->
                        uniform.set((float) colour.x(), (float) colour.y(), (float) colour.z(), (float) lobe));
        program.uniforms()
                .pictureLayer()
                .ifPresent(uniform -> uniform.set(surface.colour().layer()));
    }
}
