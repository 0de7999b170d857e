package nephele.scenes.fixed;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.math.Frustum;
import nephele.engine.model.Mesh;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.ModelOrder.Kind;
import nephele.scenes.fixed.ModelOrder.Run;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.XmlModel.Colours;
import org.joml.Matrix4dc;
import org.lwjgl.BufferUtils;

/**
 * A scene on the GPU: its models with their lights. Models that share mesh and picture take one draw, a run; those that a frame
 * submits are numbered run by run.
 */
final class SceneOnGpu implements AutoCloseable {
    private static final int LOOK_FLOATS = 16;
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3, Attribute.FLOAT2);

    private final GlContext gl;
    private final PosedScene posed;
    private final LightChains lights;
    private final List<Drawn> drawn = new ArrayList<>();
    private final Map<Mesh, GpuMesh> meshes = new HashMap<>();
    private final Map<Picture, Texture> pictures = new HashMap<>();
    private final BufferTexture looks;
    private final ModelPoses places;
    private final int staying;

    /** The numbers of the models that a frame submits, uploaded when they have changed. */
    private final BufferTexture visible;

    private final IntBuffer staging;
    private final int[] numbers;
    private final int[] uploaded;
    private int uploadedSize = -1;

    /** Where the numbers of each run begin; the last one is where they end. */
    private final int[] starts;

    /** A run with its GPU resources. */
    private record Drawn(Run run, GpuMesh mesh, Texture picture) {}

    /** @param around the scene that contains a movable entity; {@code null} for a scene that stays */
    private SceneOnGpu(GlContext gl, Source source, Texture white, PosedScene around) {
        this.gl = gl;
        posed = PosedScene.of(source.scene());
        lights = new LightChains(gl, posed, around);
        ModelOrder order = ModelOrder.of(posed, source.files(), around != null);
        staying = order.staying();
        places = new ModelPoses(gl, posed, order);
        visible = BufferTexture.changingIntegers(gl, "visible models");
        staging = BufferUtils.createIntBuffer(order.count());
        numbers = new int[order.count()];
        uploaded = new int[order.count()];
        starts = new int[order.runs().size() + 1];
        looks = BufferTexture.ofFloats(gl, "models' looks", looks(order));
        for (Run run : order.runs()) {
            Kind kind = run.kind();
            GpuMesh mesh = meshes.computeIfAbsent(kind.mesh(), this::uploaded);
            Texture picture = kind.picture() == null
                    ? white
                    : pictures.computeIfAbsent(kind.picture(), from -> PictureTexture.of(gl, "picture", from));
            drawn.add(new Drawn(run, mesh, picture));
        }
    }

    static SceneOnGpu atHome(GlContext gl, Source source, Texture white) {
        return new SceneOnGpu(gl, source, white, null);
    }

    /** @param around the surrounding scene */
    static SceneOnGpu entity(GlContext gl, Source source, Texture white, SceneOnGpu around) {
        return new SceneOnGpu(gl, source, white, around.posed);
    }

    private float[] looks(ModelOrder order) {
        float[] packed = new float[LOOK_FLOATS * order.count()];
        for (int number = 0; number < order.count(); number++) {
            int at = LOOK_FLOATS * number;
            int model = order.posedNumber(number);
            Colours colours = posed.model(model).colours();
            colours.ambient().put(packed, at, lights.firstOfModel(model));
            colours.diffuse().put(packed, at + 4, 1);
            colours.specular().put(packed, at + 8, colours.shininess());
            colours.emissive().put(packed, at + 12, 1);
        }
        return packed;
    }

    private GpuMesh uploaded(Mesh from) {
        ByteBuffer vertices = BufferUtils.createByteBuffer(from.vertexCount() * FORMAT.strideBytes())
                .order(ByteOrder.nativeOrder());
        for (int v = 0; v < from.vertexCount(); v++) {
            put(vertices, from.positions(), 3 * v, 3);
            put(vertices, from.normals(), 3 * v, 3);
            put(vertices, from.textureCoordinates(), 2 * v, 2);
        }
        IntBuffer triangles = BufferUtils.createIntBuffer(from.indices().length).put(from.indices());
        return new GpuMesh(gl, "model", FORMAT, vertices.flip(), triangles.flip());
    }

    private static void put(ByteBuffer to, float[] from, int first, int count) {
        for (int i = first; i < first + count; i++) {
            to.putFloat(from[i]);
        }
    }

    void pose(double seconds, Matrix4dc worldFromScene) {
        posed.at(seconds);
        places.update(worldFromScene);
        lights.update(worldFromScene);
    }

    void draw(FixedProgram.Inputs inputs, Frustum frustum) {
        cull(frustum);
        visible.bind(TextureUnit.SCENE_VISIBLE);
        if (inputs.isLit()) {
            lights.bind();
            looks.bind(TextureUnit.SCENE_LOOKS);
        }
        for (int i = 0; i < drawn.size(); i++) {
            if (starts[i + 1] > starts[i]) {
                draw(drawn.get(i), i, inputs);
            }
        }
    }

    /** Collects the models that may be in the view, and uploads their numbers if they are others than before. */
    private void cull(Frustum frustum) {
        int size = 0;
        for (int i = 0; i < drawn.size(); i++) {
            Run run = drawn.get(i).run();
            for (int number = run.first(); number < run.end(); number++) {
                if (places.maySee(number, frustum)) {
                    numbers[size++] = number;
                }
            }
            starts[i + 1] = size;
        }
        if (size != uploadedSize || !Arrays.equals(numbers, 0, size, uploaded, 0, size)) {
            visible.upload(staging.clear().put(numbers, 0, size).flip());
            System.arraycopy(numbers, 0, uploaded, 0, size);
            uploadedSize = size;
        }
    }

    private void draw(Drawn each, int number, FixedProgram.Inputs inputs) {
        Kind kind = each.run().kind();
        if (kind.moves()) {
            places.bindMoving();
            inputs.firstPlace().set(staying);
        } else {
            places.bindStaying();
            inputs.firstPlace().set(0);
        }
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, kind.culled());
        if (inputs.isLit()) {
            each.picture().bind(TextureUnit.SCENE_PICTURE);
        }
        inputs.firstVisible().set(starts[number]);
        each.mesh().drawInstanced(0, kind.mesh().indices().length, starts[number + 1] - starts[number]);
    }

    @Override
    public void close() {
        meshes.values().forEach(GpuMesh::close);
        pictures.values().forEach(Texture::close);
        looks.close();
        places.close();
        visible.close();
        lights.close();
    }
}
