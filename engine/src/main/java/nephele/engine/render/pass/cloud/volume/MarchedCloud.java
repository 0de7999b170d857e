package nephele.engine.render.pass.cloud.volume;

import java.util.Map;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.LitCells;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Noise;

/** A cloud of the level through whose cells rays are marched. */
final class MarchedCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final CloudSource cloud;
    private final Map<CloudPixels, MarchPrograms> programs;
    private final FullScreenTriangle triangle;
    private final double stepCells;
    private final LitCells cells;
    /** {@code null} if the density comes from cells. */
    private final NoiseTextures noiseTextures;

    /** Its noise at the time; {@code null} if the density comes from cells. */
    private NoiseField noise;

    MarchedCloud(
            LoadContext context,
            PlacedCloud placed,
            Map<CloudPixels, MarchPrograms> programs,
            FullScreenTriangle triangle) {
        this.placed = placed;
        this.programs = programs;
        this.triangle = triangle;
        cloud = placed.source();
        stepCells = context.quality().cloudStep();
        cells = new LitCells(context, placed);
        noiseTextures = cloud.isProfiled()
                ? new NoiseTextures(context, (ProfiledNoise) cloud.noise(0).density(), cloud.levels())
                : null;
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        cells.follow(environment, now);
        if (noiseTextures != null) {
            noise = cloud.noise(cloud.evolves() ? now.seconds() : 0);
            noiseTextures.show(cells.shown().plans(), cells.toCome().plans());
        }
    }

    @Override
    public void draw(CloudCanvas canvas) {
        MarchProgram program = programs.get(canvas.pixels()).of(kind());
        program.use();
        canvas.put(program.pixels(), placed);
        cells.bind(program.cells(), canvas.view(), canvas.focus(), stepCells);
        if (noiseTextures != null) {
            noiseTextures.bind(program.noisePlaces(), noise, canvas.view().eye().minus(placed.drift()));
        }
        triangle.draw();
    }

    private Noise kind() {
        return !cloud.isProfiled() ? Noise.NONE : cloud.evolves() ? Noise.EVOLVING : Noise.STILL;
    }
}
