package nephele.engine.render.pass.cloud;

import java.util.function.UnaryOperator;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.light.BeamLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality.PuffLight;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector4;

/** Draws a cloud that is divided into puffs: each as a quad, or all of them by an {@link Impostor}. */
public final class PuffCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final LitCloud cells;
    private final CloudPrograms<PuffUniforms> programs;
    /** The light along the beam; {@code null} for {@link PuffLight#TAIL}. */
    private final BeamLight beam;

    private final PuffQuads quads;
    /** {@code null} if it is always drawn puff by puff, as is the following. */
    private final Impostors impostors;

    private final Impostor impostor;
    private DrawnCloud sampledFrom;
    private DrawnCloud sampledTo;
    private double fraction;
    private CloudPuffs from;
    private CloudPuffs to;
    /** The puffs at the time of the frame; {@code null} until something needs them. */
    private CloudPuffs now;

    private record PuffUniforms(
            CloudPrograms.Shared cloud, Scalar margin, @IfRead Vector4 stepping, @IfRead Vector4 beamLobes) {}

    /**
     * @param context without impostors if puffs look other as the view turns
     * @param shaders path of both shaders in the folder of clouds, without the ending
     * @param choices adds definitions
     */
    public PuffCloud(
            CloudContext context, PlacedCloud placed, String shaders, PuffLight light, UnaryOperator<Defines> choices) {
        this.placed = placed;
        beam = light.beam(placed.source().physics().optics());
        cells = new LitCloud(context.load(), placed);
        programs = new CloudPrograms<>(
                context,
                shaders + ".vert",
                shaders + ".frag",
                defines -> choices.apply(cells.define(defines).with("QUADS").withIf(beam != null, "BEAM")),
                PuffUniforms.class);
        quads = context.load().own(new PuffQuads(context.load().gl()));
        impostors = context.impostors();
        impostor = impostors == null ? null : impostors.add(context, this);
    }

    @Override
    public void follow(Environment environment, CloudInterval interval) {
        cells.follow(environment, interval);
        boolean isSame = cells.earlier() == sampledFrom && cells.later() == sampledTo;
        if (!isSame) {
            from = cells.earlier() == sampledTo ? to : CloudPuffs.of(cells.earlier());
            to = cells.later() == cells.earlier() ? from : CloudPuffs.of(cells.later());
            sampledFrom = cells.earlier();
            sampledTo = cells.later();
        }
        if (!isSame || cells.fraction() != fraction) {
            fraction = cells.fraction();
            now = null;
        }
        if (impostor != null) {
            impostor.follow(from, to);
        }
    }

    PlacedCloud placed() {
        return placed;
    }

    LitCloud cells() {
        return cells;
    }

    /** Returns the puffs at the time of the frame. */
    CloudPuffs puffs() {
        if (now == null) {
            now = from.towards(to, fraction);
        }
        return now;
    }

    @Override
    public void draw(CloudCanvas canvas) {
        if (impostors != null && impostors.draw(impostor, canvas)) {
            return;
        }
        use(canvas);
        quads.upload(puffs(), canvas.view().eye().minus(placed.drift()), placed.presence());
        quads.draw();
    }

    /** Makes the program that draws puffs on a canvas the current one. */
    void use(CloudCanvas canvas) {
        PuffUniforms uniforms = programs.use(canvas.pixels());
        canvas.put(uniforms.cloud, placed);
        cells.put(uniforms.cloud, canvas.view(), canvas.focus());
        uniforms.margin.set(canvas.margin());
        if (beam == null) {
            uniforms.stepping.set(1, 0.5, canvas.view().eyeY(), cells.depthAround(canvas.view()));
        } else {
            CloudOptics optics = beam.optics();
            uniforms.beamLobes.set(optics.g(), optics.backG(), optics.backFraction(), beam.fading());
        }
    }
}
