package nephele.engine.render.pass.shadow;

import java.util.Comparator;
import java.util.Map;
import java.util.stream.IntStream;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.PlantList;
import nephele.engine.render.resource.PlantedScene;
import nephele.engine.scene.light.ShadowFrame;

/**
 * Draws the depth of plants into the sun's picture: the meshes of those kinds that have the fewest triangles, as many as
 * have few together, and of other kinds the impostors, with the depths of their atlases.
 */
final class PlantDepth {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";
    /** A software renderer draws as many in a second. */
    private static final long MOST_TRIANGLES = 4_000_000;

    /** @param towardsSun of impostors */
    private record SunUniforms(Uniforms.Matrix4 clipFromAnchor, @IfRead Uniforms.Vector3 towardsSun) {}

    private final GlContext gl;
    private final PlantedScene plants;
    /** For each kind whether its meshes are drawn. */
    private final boolean[] isMesh;

    private final GlProgram<SunUniforms> meshes;
    private final PlantList list;
    /** {@code null} if all are meshes. */
    private final GlProgram<SunUniforms> impostors;

    private final BillboardList quads;

    PlantDepth(LoadContext context) {
        gl = context.gl();
        plants = PlantedScene.of(context);
        list = context.own(new PlantList(gl));
        quads = context.own(new BillboardList(gl, 1));
        isMesh = meshKinds(plants, context.quality().impostorPixels() == 0 ? Long.MAX_VALUE : MOST_TRIANGLES);
        meshes = meshes();
        impostors = IntStream.range(0, isMesh.length).allMatch(kind -> isMesh[kind]) ? null : impostors();
    }

    /** @param most triangles of all kinds whose meshes are drawn */
    private static boolean[] meshKinds(PlantedScene plants, long most) {
        long[] triangles = new long[plants.meshes().size()];
        for (int plant = 0; plant < plants.count(); plant++) {
            int kind = plants.kind(plant);
            triangles[kind] += plants.meshes().get(kind).triangles();
        }
        boolean[] isMesh = new boolean[triangles.length];
        long sum = 0;
        for (int kind : fewestFirst(triangles)) {
            sum += triangles[kind];
            isMesh[kind] = sum <= most;
        }
        return isMesh;
    }

    private static int[] fewestFirst(long[] triangles) {
        return IntStream.range(0, triangles.length)
                .boxed()
                .sorted(Comparator.comparingLong(kind -> triangles[kind]))
                .mapToInt(kind -> kind)
                .toArray();
    }

    private GlProgram<SunUniforms> meshes() {
        return GlProgram.of(gl, FOLDER + "plant-depth.vert", FOLDER + "plant-depth.frag", Map.of(), SunUniforms.class);
    }

    private GlProgram<SunUniforms> impostors() {
        return GlProgram.of(
                gl,
                FOLDER + "impostor-depth.vert",
                FOLDER + "impostor-depth.frag",
                Map.of("PER_SHEET", Integer.toString(BillboardList.PER_SHEET)),
                SunUniforms.class);
    }

    /** Draws into the bound target. @param direction towards the sun, any length */
    void draw(ShadowFrame frame, Vec3 direction) {
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        plants.bind();
        float[] clip = frame.clipFromAnchor().get(new float[16]);
        meshes.use();
        meshes.uniforms().clipFromAnchor().set(clip);
        for (int kind = 0; kind < isMesh.length; kind++) {
            if (isMesh[kind]) {
                drawMeshes(kind);
            }
        }
        if (impostors != null) {
            drawImpostors(clip, Directions.unit(direction));
        }
    }

    private void drawImpostors(float[] clip, Vec3 towards) {
        impostors.use();
        impostors.uniforms().clipFromAnchor().set(clip);
        impostors.uniforms().towardsSun().set(towards);
        plants.bindAtlases();
        quads.begin();
        for (int plant = 0; plant < plants.count(); plant++) {
            if (!isMesh[plants.kind(plant)]) {
                quads.add(plant);
            }
        }
        quads.draw();
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
