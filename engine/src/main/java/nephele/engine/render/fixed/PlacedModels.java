package nephele.engine.render.fixed;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.engine.render.fixed.ModelOrder.Handedness;
import nephele.engine.render.fixed.ModelOrder.Motion;
import nephele.engine.render.fixed.ModelOrder.Run;
import nephele.engine.render.fixed.ScenePoses.Placed;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.Texture;
import nephele.engine.xmlscene.XmlModel;
import nephele.engine.xmlscene.XmlModel.Colours;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.lwjgl.BufferUtils;

/** The models of one scene on the GPU: those that stay are placed once, the others every frame; one draw a mesh and picture. */
final class PlacedModels implements AutoCloseable {
    private static final int LOOK_FLOATS = 16;
    private static final int PLACE_FLOATS = 12;

    private final GlContext gl;
    private final ModelOrder order;
    private final List<AutoCloseable> owned = new ArrayList<>();
    private final List<Drawn> drawn = new ArrayList<>();
    private final BufferTexture looks;
    private final BufferTexture stayingPlaces;
    private final BufferTexture movingPlaces;
    private final FloatBuffer moving;
    private final ModelSpheres spheres;
    private final VisibleModels visible;
    private final Matrix4d place = new Matrix4d();
    private final int staying;

    /** A run with what it is drawn with. */
    private record Drawn(Run run, ModelBuffers mesh, Texture picture) {}

    PlacedModels(GlContext gl, ModelOrder order, Texture white) {
        this.gl = gl;
        this.order = order;
        staying = order.staying();
        int count = order.models().size();
        spheres = new ModelSpheres(order);
        visible = own(new VisibleModels(gl, count));
        looks = own(BufferTexture.ofFloats(gl, "models' looks", looks(order)));
        Matrix4d identity = new Matrix4d();
        FloatBuffer places = BufferUtils.createFloatBuffer(PLACE_FLOATS * staying);
        put(places, 0, staying, identity);
        float[] copy = new float[places.limit()];
        places.get(copy);
        stayingPlaces = own(BufferTexture.ofFloats(gl, "places of what stays", copy));
        movingPlaces = own(BufferTexture.changing(gl, "places of what moves"));
        moving = BufferUtils.createFloatBuffer(PLACE_FLOATS * (count - staying));
        addRuns(white);
    }

    private <T extends AutoCloseable> T own(T made) {
        owned.add(made);
        return made;
    }

    private void addRuns(Texture white) {
        Map<Mesh, ModelBuffers> meshes = new HashMap<>();
        Map<Picture, Texture> pictures = new HashMap<>();
        for (Run run : order.runs()) {
            Mesh mesh = run.kind().mesh();
            Picture picture = run.kind().picture();
            ModelBuffers buffers = meshes.computeIfAbsent(mesh, from -> own(new ModelBuffers(gl, "model", from)));
            Texture texture = picture == null
                    ? white
                    : pictures.computeIfAbsent(picture, from -> own(PictureTexture.of(gl, "picture", from)));
            drawn.add(new Drawn(run, buffers, texture));
        }
    }

    private static float[] looks(ModelOrder order) {
        float[] packed = new float[LOOK_FLOATS * order.models().size()];
        int at = 0;
        for (Placed<XmlModel> model : order.models()) {
            Colours colours = model.what().colours();
            put(packed, at, colours.ambient(), model.lightBefore());
            put(packed, at + 4, colours.diffuse(), 1);
            put(packed, at + 8, colours.specular(), colours.shininess());
            put(packed, at + 12, colours.emissive(), 1);
            at += LOOK_FLOATS;
        }
        return packed;
    }

    private static void put(float[] packed, int at, Vec3 v, double last) {
        packed[at] = (float) v.x();
        packed[at + 1] = (float) v.y();
        packed[at + 2] = (float) v.z();
        packed[at + 3] = (float) last;
    }

    /** The rows of places, and where their spheres are. */
    private void put(FloatBuffer rows, int first, int end, Matrix4dc outer) {
        rows.clear();
        for (int number = first; number < end; number++) {
            outer.mul(order.models().get(number).group().place(), place);
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 4; column++) {
                    rows.put((float) place.get(column, row));
                }
            }
            spheres.place(number, place);
        }
        rows.flip();
    }

    /** Places what moves, after the poses have been set. */
    void update(Matrix4dc outer) {
        if (staying < order.models().size()) {
            put(moving, staying, order.models().size(), outer);
            movingPlaces.upload(moving);
        }
    }

    /** @param frustum {@code null} to submit all */
    void draw(FixedProgram.Inputs inputs, Frustum frustum) {
        visible.restart();
        for (int i = 0; i < drawn.size(); i++) {
            visible.add(drawn.get(i).run(), spheres, frustum);
        }
        visible.bind();
        if (inputs.light() != null) {
            looks.bind(FixedProgram.LOOKS_UNIT);
        }
        for (int i = 0; i < drawn.size(); i++) {
            if (visible.count(i) > 0) {
                draw(drawn.get(i), i, inputs);
            }
        }
    }

    private void draw(Drawn each, int number, FixedProgram.Inputs inputs) {
        boolean stays = each.run().kind().motion() == Motion.STAYS;
        (stays ? stayingPlaces : movingPlaces).bind(FixedProgram.PLACES_UNIT);
        boolean mirrored = each.run().kind().handedness() == Handedness.MIRRORED;
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, mirrored ? Cull.FRONT : Cull.BACK);
        if (inputs.light() != null) {
            each.picture().bind(FixedProgram.PICTURE_UNIT);
        }
        inputs.firstPlace().set(stays ? 0 : staying);
        inputs.firstVisible().set(visible.first(number));
        each.mesh().draw(visible.count(number));
    }

    @Override
    public void close() {
        for (AutoCloseable each : owned) {
            try {
                each.close();
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        }
    }
}
