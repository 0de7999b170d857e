package nephele.engine.render.frame;

import java.nio.FloatBuffer;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.TextureUnit;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.render.gl.Uniforms.Whole;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.scene.Moment;
import nephele.engine.scene.light.SkyProbes;
import nephele.engine.scene.thing.ThingCopies;
import nephele.engine.scene.thing.Things;
import nephele.engine.scene.thing.VisibleThings;
import org.lwjgl.BufferUtils;

/**
 * What moves, on the GPU: the shapes once, the instances whenever one has moved. Shaders read it by {@code
 * thing-position.glsl} and {@code thing-instance.glsl}.
 */
public final class ThingMeshes implements GlObject {
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2);

    private final Things things;
    private final ThingCopies copies;
    private final GpuMesh mesh;
    private final BufferTexture instances;
    private FloatBuffer staging = BufferUtils.createFloatBuffer(1 << 10);
    private long version;

    ThingMeshes(GlContext gl, Things things, Vec3 anchor, SkyProbes sky) {
        this.things = things;
        copies = new ThingCopies(things, anchor, sky);
        mesh = new GpuMesh(
                gl, "things", FORMAT, things.mesh().vertices(), things.mesh().indices());
        instances = BufferTexture.changing(gl, "thing instances");
    }

    public Things things() {
        return things;
    }

    public ThingCopies copies() {
        return copies;
    }

    /**
     * Brings the instances to {@code moment}; does nothing when they are there already.
     *
     * @return a number that changes with every change
     */
    public long update(Moment moment) {
        long now = copies.update(moment);
        if (now != version) {
            version = now;
            int floats = ThingCopies.FLOATS * copies.instances();
            if (floats > staging.capacity()) {
                staging = BufferUtils.createFloatBuffer(2 * floats);
            }
            instances.upload(staging.clear().put(copies.packed(), 0, floats).flip());
        }
        return now;
    }

    /** What a program that includes {@code thing-position.glsl} is told for each run of instances. */
    public record RunUniforms(Whole firstInstance, Whole partsPerThing) {
        public static RunUniforms of(Uniforms uniforms) {
            uniforms.sampler("thingInstances", TextureUnit.THING_INSTANCES);
            return new RunUniforms(uniforms.whole("firstInstance"), uniforms.whole("partsPerThing"));
        }
    }

    public void bind() {
        instances.bind(TextureUnit.THING_INSTANCES);
    }

    /** Draws one run with the program that is set and its uniforms. */
    public void draw(VisibleThings visible, int run, RunUniforms uniforms) {
        int parts = things.groups().get(visible.group(run)).parts();
        uniforms.firstInstance().set(visible.first(run));
        uniforms.partsPerThing().set(parts);
        mesh.drawInstanced(visible.mesh(run).first(), visible.mesh(run).count(), visible.count(run) / parts);
    }

    @Override
    public void close() {
        mesh.close();
        instances.close();
    }
}
