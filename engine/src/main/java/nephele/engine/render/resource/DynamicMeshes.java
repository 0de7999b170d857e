package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Whole;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.dynamic.DynamicInstances;
import nephele.engine.scene.dynamic.DynamicObjects;
import nephele.engine.scene.dynamic.VisibleInstances;
import nephele.engine.scene.probe.SkyProbes;
import org.lwjgl.BufferUtils;

/**
 * The dynamic objects on the GPU: shapes are uploaded once, instances whenever one has moved. Shaders read them through
 * {@code dynamic-position.glsl} and {@code dynamic-instance.glsl}.
 */
public final class DynamicMeshes implements GlObject {
    public static final SharedResource<DynamicMeshes> RESOURCE =
            SharedResource.of("dynamic objects", DynamicMeshes::of);

    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2);

    private final DynamicObjects dynamicObjects;
    private final DynamicInstances copies;
    private final GpuMesh mesh;
    private final BufferTexture instances;
    /** {@code null} without baked light. */
    private final BufferTexture bounced;

    private FloatBuffer staging = BufferUtils.createFloatBuffer(1 << 10);
    private long version;

    private DynamicMeshes(GlContext gl, DynamicObjects dynamicObjects, Vec3 anchor, SkyProbes sky) {
        this.dynamicObjects = dynamicObjects;
        copies = new DynamicInstances(dynamicObjects, anchor, sky);
        mesh = new GpuMesh(
                gl,
                "dynamic objects",
                FORMAT,
                dynamicObjects.mesh().vertices(),
                dynamicObjects.mesh().indices());
        instances = BufferTexture.changing(gl, "dynamic instances");
        bounced = copies.isLit() ? BufferTexture.changing(gl, "bounced light") : null;
    }

    private static DynamicMeshes of(LoadContext context) {
        Scene scene = context.scene();
        DynamicObjects all = DynamicObjects.of(
                scene.level(), scene.materials(), context.request().character());
        Vec3 anchor = context.get(SurfaceLight.RESOURCE).anchor();
        return context.own(new DynamicMeshes(context.gl(), all, anchor, context.get(AmbientLight.PROBES)));
    }

    public DynamicObjects dynamicObjects() {
        return dynamicObjects;
    }

    public DynamicInstances copies() {
        return copies;
    }

    /**
     * Updates the instances to {@code frameState}, if they differ.
     *
     * @return a number that changes with every change
     */
    public long update(FrameState frameState) {
        long now = copies.update(frameState);
        if (now != version) {
            version = now;
            upload(instances, copies.packed(), DynamicInstances.FLOATS);
            if (bounced != null) {
                upload(bounced, copies.bounced(), DynamicInstances.BOUNCED_FLOATS);
            }
        }
        return now;
    }

    private void upload(BufferTexture texture, float[] values, int ofInstance) {
        int floats = ofInstance * copies.instances();
        if (floats > staging.capacity()) {
            staging = BufferUtils.createFloatBuffer(2 * floats);
        }
        texture.upload(staging.clear().put(values, 0, floats).flip());
    }

    /** The uniforms of a program that includes {@code dynamic-position.glsl}, for each run of instances. */
    public record RunUniforms(Whole firstInstance, Whole partsPerDynamic) {}

    public void bind() {
        instances.bind(TextureUnit.DYNAMIC_INSTANCES);
        if (bounced != null) {
            bounced.bind(TextureUnit.BOUNCED_LIGHT);
        }
    }

    /** Draws one run with the current program and its uniforms. */
    public void draw(VisibleInstances visible, int run, RunUniforms uniforms) {
        int parts = dynamicObjects.groups().get(visible.group(run)).parts();
        uniforms.firstInstance().set(visible.first(run));
        uniforms.partsPerDynamic().set(parts);
        mesh.drawInstanced(visible.mesh(run).first(), visible.mesh(run).count(), visible.count(run) / parts);
    }

    @Override
    public void close() {
        mesh.close();
        instances.close();
        if (bounced != null) {
            bounced.close();
        }
    }
}
