package nephele.engine.render.pass.cloud.volume;

import java.util.EnumMap;
import java.util.Map;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Noise;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Pixels;

/** The programs that march clouds for one choice of pixels, compiled when a cloud first needs them. */
final class MarchPrograms {
    private final LoadContext context;
    private final Pixels pixels;
    private final int clouds;
    private final Map<Noise, MarchProgram> compiled = new EnumMap<>(Noise.class);

    /** @param clouds number of ranges that the programs know */
    MarchPrograms(LoadContext context, Pixels pixels, int clouds) {
        this.context = context;
        this.pixels = pixels;
        this.clouds = clouds;
    }

    MarchProgram of(Noise noise) {
        MarchProgram program = compiled.get(noise);
        if (program == null) {
            program = new MarchProgram(context, pixels, noise, clouds);
            compiled.put(noise, program);
        }
        return program;
    }
}
