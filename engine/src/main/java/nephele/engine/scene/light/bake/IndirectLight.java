package nephele.engine.scene.light.bake;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * Light worked out beforehand on the static geometry. Layers add up, because light does.
 *
 * @param sky whether the light of the sky is in it; it is not where the sky changes while one plays
 * @param layers at least one
 */
public record IndirectLight(SkyLight sky, List<Layer> layers) {
    /** Whether the sky's light is baked, or drawn live by {@link SkyVisibility}. */
    public enum SkyLight {
        BAKED,
        LIVE
    }

    /** How the light of a layer has come to its surfaces. */
    public enum Course {
        /** Light from the sky, off other surfaces, or from emissive ones. */
        INDIRECT,
        /** Light straight from sun or lamps, which other qualities draw live. */
        DIRECT
    }

    /**
     * Light that is dimmed and switched together.
     *
     * @param name the {@code layer} of the lights that it comes from; empty for all other sources
     * @param texels of the light map, row by row from the lowest
     * @param vertices of every model in order
     * @param grounds of every terrain in order: points row by row from the least z
     */
    public record Layer(
            String name, Course course, LightSamples texels, LightSamples vertices, List<LightSamples> grounds) {
        private Layer scaled(float gain) {
            return new Layer(
                    name,
                    course,
                    scaled(texels, gain),
                    scaled(vertices, gain),
                    grounds.stream().map(ground -> scaled(ground, gain)).toList());
        }

        private static LightSamples scaled(LightSamples samples, float gain) {
            LightSamples scaled = LightSamples.black(samples.points());
            scaled.add(samples, gain);
            return scaled;
        }

        private void add(Layer other, float gain) {
            texels.add(other.texels, gain);
            vertices.add(other.vertices, gain);
            for (int i = 0; i < grounds.size(); i++) {
                grounds.get(i).add(other.grounds.get(i), gain);
            }
        }
    }

    /**
     * Returns the sum of layers.
     *
     * @param isDirectBaked whether the light straight from sun and lamps is in the sum
     * @param gainOf by the name of a layer, 0 for dark, 1 as baked
     */
    public Layer sum(boolean isDirectBaked, ToDoubleFunction<String> gainOf) {
        Layer sum = null;
        for (Layer layer : layers) {
            if (layer.course() == Course.INDIRECT || isDirectBaked) {
                float gain = (float) gainOf.applyAsDouble(layer.name());
                if (sum == null) {
                    sum = layer.scaled(gain);
                } else {
                    sum.add(layer, gain);
                }
            }
        }
        return sum;
    }
}
