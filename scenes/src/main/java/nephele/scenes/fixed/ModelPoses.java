package nephele.scenes.fixed;

import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.Map;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.model.Mesh;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.scenes.fixed.ModelOrder.Run;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.WorldSpheres;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.lwjgl.BufferUtils;

/**
 * The poses of models on the GPU and their bounding spheres: static ones are uploaded once, the others whenever they
 * move.
 */
final class ModelPoses implements AutoCloseable {
    private static final int FLOATS = 12;

    /** Relative rounding error of placed vertices: floats have 24 bits, with a margin for the sums of a product. */
    private static final double ROUNDING = 0x1p-21;

    /** Distance beyond which a float's square is infinite; nothing there is visible. */
    private static final double FARTHEST_UNITS = 1e18;

    private final PosedScene posed;
    private final ModelOrder order;
    private final BoundingSphere[] inModel;
    private final WorldSpheres spheres;
    private final BufferTexture staying;
    private final BufferTexture moving;
    private final FloatBuffer staging;
    private final Matrix4d place = new Matrix4d();

    ModelPoses(GlContext gl, PosedScene posed, ModelOrder order) {
        this.posed = posed;
        this.order = order;
        inModel = spheres(order);
        spheres = new WorldSpheres(order.count(), ROUNDING);
        FloatBuffer stayed = BufferUtils.createFloatBuffer(FLOATS * order.staying());
        put(0, order.staying(), new Matrix4d(), stayed);
        staying = BufferTexture.changing(gl, "places of what stays");
        staying.upload(stayed.flip());
        moving = BufferTexture.changing(gl, "places of what moves");
        staging = BufferUtils.createFloatBuffer(FLOATS * (order.count() - order.staying()));
    }

    private static BoundingSphere[] spheres(ModelOrder order) {
        BoundingSphere[] all = new BoundingSphere[order.count()];
        Map<Mesh, BoundingSphere> known = new HashMap<>();
        for (Run run : order.runs()) {
            BoundingSphere sphere = known.computeIfAbsent(run.kind().mesh(), BoundingSphere::of);
            for (int number = run.first(); number < run.end(); number++) {
                all[number] = sphere;
            }
        }
        return all;
    }

    /** Updates the poses from the posed scene. */
    void update(Matrix4dc worldFromScene) {
        if (order.staying() < order.count()) {
            staging.clear();
            put(order.staying(), order.count(), worldFromScene, staging);
            moving.upload(staging.flip());
        }
    }

    /** Writes the first three rows of each pose matrix. */
    private void put(int first, int end, Matrix4dc worldFromScene, FloatBuffer rows) {
        for (int number = first; number < end; number++) {
            worldFromScene.mul(posed.worldFromModel(order.posedNumber(number)), place);
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 4; column++) {
                    rows.put((float) place.get(column, row));
                }
            }
            BoundingSphere sphere = inModel[number];
            Vec3 c = sphere.centre();
            spheres.place(number, c.x(), c.y(), c.z(), sphere.radius(), place);
        }
    }

    boolean maySee(int number, Frustum frustum) {
        double reach = Math.abs(spheres.x(number)) + Math.abs(spheres.y(number)) + Math.abs(spheres.z(number));
        return reach + spheres.radius(number) < FARTHEST_UNITS && spheres.maySee(number, frustum);
    }

    void bindStaying() {
        staying.bind(TextureUnit.SCENE_PLACES);
    }

    void bindMoving() {
        moving.bind(TextureUnit.SCENE_PLACES);
    }

    @Override
    public void close() {
        staying.close();
        moving.close();
    }
}
