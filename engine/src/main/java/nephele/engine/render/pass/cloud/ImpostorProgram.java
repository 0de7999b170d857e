package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.PuffSlabs;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.QuadStream;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/** {@code impostor.frag}, which draws the pictures of the slabs of a cloud, the farthest first. */
final class ImpostorProgram {
    private static final String SHADERS = "/nephele/engine/render/pass/cloud/impostor";

    private final GlProgram<Places> program;

    private record Places(PixelUniforms pixels, Quad quad, Slab slab) {}

    /** The rectangle that is drawn, relative to the eye, metres: its middle and half of its sides. */
    private record Quad(Uniforms.Vector3 centre, Uniforms.Vector3 across, Uniforms.Vector3 upwards) {}

    /** The axes of a picture, the eye along them, and the numbers of {@code slab}. */
    private record Slab(
            Uniforms.Vector3 right,
            Uniforms.Vector3 up,
            Uniforms.Vector3 forward,
            Uniforms.Vector3 eye,
            Uniforms.Vector4 numbers) {}

    ImpostorProgram(CloudContext context, CloudPixels pixels) {
        var defines = PixelUniforms.defines(context, pixels).with("QUADS").values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(SHADERS + ".vert", defines),
                ShaderSource.load(SHADERS + ".frag", defines),
                uniforms -> {
                    uniforms.sampler("impostor", TextureUnit.IMPOSTOR);
                    uniforms.sampler("impostorPlaces", TextureUnit.IMPOSTOR_PLACES);
                    return new Places(
                            PixelUniforms.of(uniforms, context, pixels),
                            new Quad(
                                    uniforms.vector3("quadCentre"),
                                    uniforms.vector3("quadAcross"),
                                    uniforms.vector3("quadUpwards")),
                            new Slab(
                                    uniforms.vector3("slabRight"),
                                    uniforms.vector3("slabUp"),
                                    uniforms.vector3("slabForward"),
                                    uniforms.vector3("eyeAtSlab"),
                                    uniforms.vector4("slab")));
                });
    }

    void draw(CloudCanvas canvas, Impostor impostor, QuadStream quad) {
        program.use();
        Places places = program.uniforms();
        canvas.put(places.pixels, impostor.placed());
        ImpostorPicture picture = impostor.shown();
        PuffSlabs slabs = picture.slabs();
        Basis axes = slabs.axes();
        Vec3 moved = canvas.view().eye().minus(impostor.placed().drift()).minus(slabs.eye());
        set(places.slab.right, axes.right(), 1);
        set(places.slab.up, axes.up(), 1);
        set(places.slab.forward, axes.back(), -1);
        places.slab.eye.set(
                (float) moved.dot(axes.right()), (float) moved.dot(axes.up()), (float) -moved.dot(axes.back()));
        for (int i = 0; i < slabs.slabs().size(); i++) {
            PuffSlabs.Slab slab = slabs.slabs().get(i);
            places.slab.numbers.set(
                    (float) slab.middle(),
                    (float) (0.5 / slabs.raster().tanHalfWidth()),
                    (float) (0.5 / slabs.raster().tanHalfHeight()),
                    (float) picture.presence(impostor.placed()));
            place(places.quad, slabs, slab, moved, canvas.margin());
            picture.bindTextures(i);
            quad.draw();
        }
    }

    private static void place(Quad quad, PuffSlabs slabs, PuffSlabs.Slab slab, Vec3 moved, double margin) {
        PuffSlabs.Sides sides = slab.whole();
        Basis axes = slabs.axes();
        double metres = slab.middle();
        Vec3 centre = axes.right()
                .scaled(metres * (sides.left() + sides.right()) / 2)
                .addScaled(metres * (sides.low() + sides.high()) / 2, axes.up())
                .addScaled(-metres, axes.back())
                .minus(moved);
        double wider = margin * centre.length();
        set(quad.centre, centre, 1);
        set(quad.across, axes.right(), metres * (sides.right() - sides.left()) / 2 + wider);
        set(quad.upwards, axes.up(), metres * (sides.high() - sides.low()) / 2 + wider);
    }

    private static void set(Uniforms.Vector3 place, Vec3 v, double factor) {
        place.set((float) (factor * v.x()), (float) (factor * v.y()), (float) (factor * v.z()));
    }
}
