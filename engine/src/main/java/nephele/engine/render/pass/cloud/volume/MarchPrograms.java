package nephele.engine.render.pass.cloud.volume;

import java.util.EnumMap;
import java.util.Map;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Noise;

/** The programs that march clouds for one choice of pixels, compiled when a cloud first needs them. */
final class MarchPrograms {
    private final CloudContext context;
    private final CloudPixels pixels;
    private final Map<Noise, MarchProgram> compiled = new EnumMap<>(Noise.class);

    MarchPrograms(CloudContext context, CloudPixels pixels) {
        this.context = context;
        this.pixels = pixels;
    }

    MarchProgram of(Noise noise) {
        return compiled.computeIfAbsent(noise, wanted -> new MarchProgram(context, pixels, wanted));
    }
}
