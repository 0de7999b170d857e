package nephele.scenes.fixed;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.math.Frustum;
import nephele.engine.model.Mesh;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.scenes.fixed.ModelOrder.Handedness;
import nephele.scenes.fixed.ModelOrder.Kind;
import nephele.scenes.fixed.ModelOrder.Motion;
import nephele.scenes.fixed.ModelOrder.Run;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.XmlModel.Colours;
import org.joml.Matrix4dc;

/** The models of one scene on the GPU; models that share mesh and picture take one draw. */
final class FixedModels implements AutoCloseable {
    private static final int LOOK_FLOATS = 16;

    private final GlContext gl;
    private final List<Drawn> drawn = new ArrayList<>();
    private final Map<Mesh, ModelBuffers> meshes = new HashMap<>();
    private final Map<Picture, Texture> pictures = new HashMap<>();
    private final BufferTexture looks;
    private final ModelPoses places;
    private final VisibleModels visible;
    private final int staying;

    /** A run with its GPU resources. */
    private record Drawn(Run run, ModelBuffers mesh, Texture picture) {}

    FixedModels(GlContext gl, PosedScene posed, ModelOrder order, Texture white, LightChains lights) {
        this.gl = gl;
        staying = order.staying();
        places = new ModelPoses(gl, posed, order);
        visible = new VisibleModels(gl, order.count());
        looks = BufferTexture.ofFloats(gl, "models' looks", looks(posed, order, lights));
        for (Run run : order.runs()) {
            Kind kind = run.kind();
            ModelBuffers mesh = meshes.computeIfAbsent(kind.mesh(), from -> new ModelBuffers(gl, "model", from));
            Texture picture = kind.picture() == null
                    ? white
                    : pictures.computeIfAbsent(kind.picture(), from -> PictureTexture.of(gl, "picture", from));
            drawn.add(new Drawn(run, mesh, picture));
        }
    }

    private static float[] looks(PosedScene posed, ModelOrder order, LightChains lights) {
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

    /** Updates the models from the posed scene. */
    void update(Matrix4dc worldFromScene) {
        places.update(worldFromScene);
    }

    void draw(FixedProgram.Inputs inputs, Frustum frustum) {
        visible.restart();
        for (int i = 0; i < drawn.size(); i++) {
            visible.add(drawn.get(i).run(), places, frustum);
        }
        visible.bind();
        if (inputs.light() != null) {
            looks.bind(TextureUnit.SCENE_LOOKS);
        }
        for (int i = 0; i < drawn.size(); i++) {
            if (visible.count(i) > 0) {
                draw(drawn.get(i), i, inputs);
            }
        }
    }

    private void draw(Drawn each, int number, FixedProgram.Inputs inputs) {
        Kind kind = each.run().kind();
        if (kind.motion() == Motion.STAYS) {
            places.bindStaying();
            inputs.firstPlace().set(0);
        } else {
            places.bindMoving();
            inputs.firstPlace().set(staying);
        }
        Cull cull = kind.handedness() == Handedness.MIRRORED ? Cull.FRONT : Cull.BACK;
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, cull);
        if (inputs.light() != null) {
            each.picture().bind(TextureUnit.SCENE_PICTURE);
        }
        inputs.firstVisible().set(visible.first(number));
        each.mesh().draw(visible.count(number));
    }

    @Override
    public void close() {
        meshes.values().forEach(ModelBuffers::close);
        pictures.values().forEach(Texture::close);
        looks.close();
        places.close();
        visible.close();
    }
}
