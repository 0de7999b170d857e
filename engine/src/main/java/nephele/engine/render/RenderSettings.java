package nephele.engine.render;

import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;

/** What the caller, not the level, decides about a picture. */
public record RenderSettings(Output output, Quality quality, Culling culling) {
    /** OFF draws everything: what ON must not differ from. */
    public enum Culling {
        ON,
        OFF
    }

    public static RenderSettings of(Output output) {
        return new RenderSettings(output, Quality.HIGH, Culling.ON);
    }

    public RenderSettings with(Culling newCulling) {
        return new RenderSettings(output, quality, newCulling);
    }
}
