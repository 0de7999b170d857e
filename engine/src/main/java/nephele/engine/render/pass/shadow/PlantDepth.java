package nephele.engine.render.pass.shadow;

import java.util.Map;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.PlantList;
import nephele.engine.render.resource.PlantSource;
import nephele.engine.render.resource.PlantedScene;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.ShadowFrame;

/**
 * Draws the depth of plants into the sun's picture: their meshes if all together have few triangles, otherwise their
 * impostors, with the depths of their atlases.
 */
final class PlantDepth {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";
    /** A software renderer draws as many in a second. */
    private static final long MOST_TRIANGLES = 4_000_000;

    private record MeshUniforms(Uniforms.Matrix4 clipFromAnchor) {}

    private record SunUniforms(Uniforms.Matrix4 clipFromAnchor, Uniforms.Vector3 towardsSun) {}

    private final GlContext gl;
    private final PlantedScene plants;
    /** {@code null} if impostors are drawn. */
    private final GlProgram<MeshUniforms> meshes;

    private final PlantList list;
    /** {@code null} if meshes are drawn. */
    private final GlProgram<SunUniforms> impostors;

    private final BillboardList quads;

    PlantDepth(LoadContext context) {
        gl = context.gl();
        Scene scene = context.scene();
        PixelFormat format = context.output() == Output.PLAIN ? PixelFormat.RGBA8 : PixelFormat.SRGB8_ALPHA8;
        Vec3 anchor = context.shared().surfaceLight().anchor();
        PlantSource source =
                PlantSource.of(scene, anchor, format, context.quality().impostorPixels());
        plants = context.share(PlantedScene.class, source, () -> new PlantedScene(gl, scene, source));
        list = context.own(new PlantList(gl));
        quads = context.own(new BillboardList(gl));
        boolean isMeshes = triangles() <= MOST_TRIANGLES;
        meshes = isMeshes ? meshes() : null;
        impostors = isMeshes ? null : impostors();
    }

    private long triangles() {
        long sum = 0;
        for (int i = 0; i < plants.count(); i++) {
            sum += plants.meshes().get(plants.kind(i)).triangles();
        }
        return sum;
    }

    private GlProgram<MeshUniforms> meshes() {
        return new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "plant-depth.vert", Map.of()),
                ShaderSource.load(FOLDER + "plant-depth.frag", Map.of()),
                uniforms -> {
                    tie(uniforms);
                    return new MeshUniforms(uniforms.matrix4("clipFromAnchor"));
                });
    }

    private GlProgram<SunUniforms> impostors() {
        return new GlProgram<>(
                gl,
                ShaderSource.load(
                        FOLDER + "impostor-depth.vert", Map.of("PER_SHEET", Integer.toString(BillboardList.PER_SHEET))),
                ShaderSource.load(FOLDER + "impostor-depth.frag", Map.of()),
                uniforms -> {
                    tie(uniforms);
                    uniforms.sampler("plantKinds", TextureUnit.PLANT_KINDS);
                    uniforms.sampler("impostorColours", TextureUnit.COLOURS);
                    uniforms.sampler("impostorShapes", TextureUnit.IMPOSTOR_SHAPES);
                    return new SunUniforms(uniforms.matrix4("clipFromAnchor"), uniforms.vector3("towardsSun"));
                });
    }

    private static void tie(Uniforms uniforms) {
        uniforms.sampler("plants", TextureUnit.PLANTS);
        uniforms.sampler("plantOrder", TextureUnit.PLANT_ORDER);
    }

    /** Draws into the bound target. @param direction towards the sun, any length */
    void draw(ShadowFrame frame, Vec3 direction) {
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        plants.bind();
        float[] clip = frame.clipFromAnchor().get(new float[16]);
        if (meshes != null) {
            meshes.use();
            meshes.uniforms().clipFromAnchor().set(clip);
            for (int kind = 0; kind < plants.meshes().size(); kind++) {
                drawMeshes(kind);
            }
        } else {
            impostors.use();
            impostors.uniforms().clipFromAnchor().set(clip);
            Vec3 towards = Directions.unit(direction);
            impostors.uniforms().towardsSun().set((float) towards.x(), (float) towards.y(), (float) towards.z());
            plants.bindAtlases();
            quads.begin();
            for (int plant = 0; plant < plants.count(); plant++) {
                quads.add(plant);
            }
            quads.draw();
        }
    }

    private void drawMeshes(int kind) {
        list.begin();
        for (int plant = 0; plant < plants.count(); plant++) {
            if (plants.kind(plant) == kind) {
                list.add(plant);
            }
        }
        list.draw(plants.meshes().get(kind));
    }
}
