package nephele.engine.render.frame;

import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.FrontFace;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.render.gl.shader.UniformBlock;
import nephele.engine.scene.View;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The uniform block {@code Frame} of {@code frame.glsl}: the numbers of a view that every shader uses. */
public final class FrameUniforms implements GlObject {
    /**
     * Distance by which a nested view's clip plane lies behind the exit. A portal is drawn slightly in front of its
     * wall and so covers pixels of ground equally close to the wall; in the nested view, that ground is this far behind
     * the exit and must not be clipped.
     */
    private static final double CLIP_SLACK_METRES = 5e-4;

    private static final int FLOATS = 16 + 17 * 4;
    private static final int SAMPLE_POSITIONS = 40;
    private static final int AIR = 60;
    private static final int FOG_PLACE = 80;

    private final DrawState state;
    /** {@code null} without fog. */
    private final FogTransmittance fog;

    private final UniformBuffer buffer;
    private final float[] values = new float[FLOATS];
    private final Matrix4d matrix = new Matrix4d();
    private final Matrix4d shift = new Matrix4d();
    private final Vector3d direction = new Vector3d();

    /** @param environment stays the same in all frames */
    public FrameUniforms(GlContext gl, Environment environment) {
        state = gl.state();
        buffer = new UniformBuffer(gl, "frame uniforms", FLOATS);
        fog = FogTransmittance.of(environment).orElse(null);
        if (fog != null) {
            put(36, fog.radiance().toVector());
            values[39] = (float) fog.extinctionPerMetre();
            values[FOG_PLACE + 1] = (float) (1 / fog.scaleHeightMetres());
        }
    }

    /**
     * Sets the positions of a pixel's samples.
     *
     * @param positions x and y of each, pixels from the pixel's centre
     */
    public void samplePositions(float[] positions) {
        System.arraycopy(positions, 0, values, SAMPLE_POSITIONS, positions.length);
    }

    /**
     * Sets the numbers of the air for the next view: {@code airPlace}, {@code airTowards} and {@code airIrradiance}.
     *
     * @param tableMetres height for which the air is tabulated
     */
    public void air(double tableMetres, SunAndMoon lights) {
        double height = Math.min(Air.TOP_METRES, tableMetres);
        values[AIR] = (float) height;
        values[AIR + 1] = (float) SkyTable.horizon(height);
        values[AIR + 2] = (float) AerialTable.column(height);
        values[AIR + 3] = (float) AerialTable.density(height);
        putAzimuth(AIR + 4, lights.towardsSun());
        values[AIR + 6] = lights.moonlight().shines() ? 1 : 0;
        putAzimuth(AIR + 8, lights.moonlight().towardsMoon());
        lights.environment().sun().irradiance().put(values, AIR + 12, 0);
        lights.moonIrradiance().put(values, AIR + 16, lights.moonlight().shines() ? 1 : 0);
    }

    private void putAzimuth(int at, Vec3 towards) {
        double level = Math.max(1e-12, Math.hypot(towards.x(), towards.z()));
        values[at] = (float) (towards.x() / level);
        values[at + 1] = (float) (towards.z() / level);
    }

    /**
     * Sets the view of the following draws: its numbers, and the winding of triangles in it.
     *
     * @param exposure factor on radiance before the tone curve
     */
    public void upload(View view, double exposure) {
        upload(view, exposure, 0, 0);
    }

    /**
     * Sets the view as {@link #upload(View, double)} does, moved in the picture.
     *
     * @param acrossShift of the picture, in halves of its width; {@code upShift} in halves of its height
     */
    void upload(View view, double exposure, double acrossShift, double upShift) {
        view.clipFromRelative(matrix);
        if (acrossShift != 0 || upShift != 0) {
            matrix.mulLocal(shift.translation(acrossShift, upShift, 0));
        }
        matrix.get(values);
        put(16, view.direction(view.projection().tanHalfWidth(), 0, 0, direction));
        put(20, view.direction(0, view.projection().tanHalfHeight(), 0, direction));
        put(24, view.direction(0, 0, -1, direction));
        values[19] = (float) acrossShift;
        values[23] = (float) upShift;
        values[27] = view.isMirrored() ? -1 : 1;
        values[28] = (float) exposure;
        put(56, view.tint());
        putClip(view);
        if (fog != null) {
            values[FOG_PLACE] = (float) fog.scaledAltitude(view.eyeY());
        }
        buffer.upload(values);
        buffer.bind(UniformBlock.FRAME);
        state.frontFace(view.isMirrored() ? FrontFace.CLOCKWISE : FrontFace.COUNTER_CLOCKWISE);
    }

    private void putClip(View view) {
        // Mesa's llvmpipe 22.3 may continue to clip by a distance that was just disabled; a zero plane clips nothing.
        Plane clip = view.clip();
        put(32, clip == null ? direction.zero() : direction.set(clip.nx(), clip.ny(), clip.nz()));
        double inFront = clip == null ? 1 : clip.signedDistance(view.eyeX(), view.eyeY(), view.eyeZ());
        values[35] = (float) (inFront + CLIP_SLACK_METRES);
    }

    private void put(int at, Vector3dc v) {
        values[at] = (float) v.x();
        values[at + 1] = (float) v.y();
        values[at + 2] = (float) v.z();
    }

    @Override
    public void close() {
        buffer.close();
    }
}
