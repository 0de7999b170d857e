package nephele.engine.render.pass.cloud.skybox;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.PixelUniforms;
import nephele.engine.render.pass.cloud.PlacedCloud;

/** {@code skybox.frag} with the places of its numbers. */
final class SkyboxProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlProgram<Places> program;

    private record Places(
            PixelUniforms pixels, FacePlaces shown, FacePlaces before, Uniforms.Vector3 layer, Uniforms.Scalar fade) {}

    private record FacePlaces(
            List<Uniforms.Vector3> axes,
            Uniforms.Vector3 along,
            Uniforms.Vector3 against,
            Uniforms.Vector2 half,
            Uniforms.Vector4 wind) {
        static FacePlaces of(Uniforms uniforms, int picture) {
            return new FacePlaces(
                    List.of(
                            uniforms.vector3("skyAxes[" + 3 * picture + "]"),
                            uniforms.vector3("skyAxes[" + (3 * picture + 1) + "]"),
                            uniforms.vector3("skyAxes[" + (3 * picture + 2) + "]")),
                    uniforms.vector3("skyLayers[" + 2 * picture + "]"),
                    uniforms.vector3("skyLayers[" + (2 * picture + 1) + "]"),
                    uniforms.vector2("skyHalf[" + picture + "]"),
                    uniforms.vector4("skyWind[" + picture + "]"));
        }

        void put(SkyPicture picture, Vec3 drift) {
            BakedFaces faces = picture.faces();
            put(axes.get(0), faces.axes().right());
            put(axes.get(1), faces.axes().up());
            put(axes.get(2), faces.axes().back());
            List<Integer> layers = faces.layers();
            along.set(layers.get(0), layers.get(2), layers.get(4));
            against.set(layers.get(1), layers.get(3), layers.get(5));
            half.set((float) faces.halfWidth(), (float) faces.halfHeight());
            Vec3 blown = drift.minus(picture.moment().drift());
            wind.set((float) blown.x(), (float) blown.y(), (float) blown.z(), (float) picture.distanceOfShift());
        }

        private static void put(Uniforms.Vector3 place, Vec3 v) {
            place.set((float) v.x(), (float) v.y(), (float) v.z());
        }
    }

    SkyboxProgram(CloudContext context, CloudPixels pixels) {
        var defines = PixelUniforms.defines(context, pixels).values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(FOLDER + "cloud.vert", defines),
                ShaderSource.load(FOLDER + "skybox/skybox.frag", defines),
                uniforms -> {
                    uniforms.sampler("bakedFaces", TextureUnit.CLOUD_FACES);
                    uniforms.sampler("bakedBefore", TextureUnit.CLOUD_FACES_BEFORE);
                    return new Places(
                            PixelUniforms.of(uniforms, context, pixels),
                            FacePlaces.of(uniforms, 0),
                            FacePlaces.of(uniforms, 1),
                            uniforms.vector3("skyLayer"),
                            uniforms.scalar("fade"));
                });
    }

    /** @param fade share of what is shown, the rest is what was shown before */
    void use(CloudCanvas canvas, PlacedCloud placed, double fade) {
        program.use();
        Places places = program.uniforms();
        canvas.put(places.pixels, placed);
        places.fade.set((float) fade);
    }

    /** Sets the height of a layer's middle over the bake point, and the bend of layers around an eye at a height. */
    void putLayer(double heightOfMiddle, double halfCurvature, double height) {
        program.uniforms().layer.set((float) heightOfMiddle, (float) halfCurvature, (float) height);
    }

    /** @param drift how far the wind has carried the cloud */
    void putShown(SkyPicture picture, Vec3 drift) {
        program.uniforms().shown.put(picture, drift);
    }

    /** @param drift how far the wind has carried the cloud */
    void putBefore(SkyPicture picture, Vec3 drift) {
        program.uniforms().before.put(picture, drift);
    }
}
