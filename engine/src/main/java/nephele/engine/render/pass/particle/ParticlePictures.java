package nephele.engine.render.pass.particle;

import java.nio.ByteBuffer;
import nephele.engine.math.SeededNoise;
import nephele.engine.particle.ParticlePicture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import org.lwjgl.system.MemoryUtil;

/**
 * The pictures of billows, tongues and clouds in their squares, from noise: coverage, which is zero along the edges, and the
 * slope of a billow's front, 0.5 for none.
 */
final class ParticlePictures {
    private static final int TEXELS = 96;
    private static final int FIRST = ParticlePicture.BILLOW.first();

    /** Middle and radius of the parts of a cloud. */
    private static final double[][] BALLS = {
        {-0.5, -0.2, 0.36}, {-0.18, 0.02, 0.46}, {0.22, -0.04, 0.44}, {0.54, -0.22, 0.32}, {0.02, 0.26, 0.36}
    };

    private ParticlePictures() {}

    /** Returns an array texture: a layer for each variant from the first billow on. */
    static Texture texture(GlContext gl) {
        int layers = ParticlePicture.CLOUD.first() + ParticlePicture.CLOUD.variants() - FIRST;
        Texture texture = new Texture(
                gl,
                "particles",
                Texture.Shape.ARRAY,
                PixelFormat.RGBA8,
                new Texture.Extent(TEXELS, TEXELS, layers),
                Sampling.LINEAR_CLAMP);
        ByteBuffer texels = MemoryUtil.memAlloc(4 * TEXELS * TEXELS);
        for (int layer = 0; layer < layers; layer++) {
            boolean isBillow = FIRST + layer < ParticlePicture.TONGUE.first();
            for (int i = 0; i < TEXELS * TEXELS; i++) {
                double u = 2 * (i % TEXELS + 0.5) / TEXELS - 1;
                double v = 2 * (i / TEXELS + 0.5) / TEXELS - 1;
                double cover = cover(FIRST + layer, u, v);
                texels.put(4 * i, unsigned(cover));
                texels.put(4 * i + 1, unsigned(0.5 + 0.5 * (isBillow ? slope(u, v, 1, 0, layer) : 0)));
                texels.put(4 * i + 2, unsigned(0.5 + 0.5 * (isBillow ? slope(u, v, 0, 1, layer) : 0)));
                texels.put(4 * i + 3, unsigned(1));
            }
            texture.upload(layer, texels);
        }
        MemoryUtil.memFree(texels);
        return texture;
    }

    private static double cover(int picture, double u, double v) {
        int variant = picture - FIRST;
        if (picture >= ParticlePicture.CLOUD.first()) {
            return cloud(u, v, variant);
        }
        return picture >= ParticlePicture.TONGUE.first() ? tongue(u, v, variant) : billow(u, v, variant);
    }

    private static byte unsigned(double fraction) {
        return (byte) Math.round(255 * Math.min(1, Math.max(0, fraction)));
    }

    /** Returns by how much the front of a billow faces a direction: round as a whole, with bumps of noise. */
    private static double slope(double u, double v, double toU, double toV, int variant) {
        double step = 0.04;
        double before = noise(u - step * toU, v - step * toV, variant, 2.3);
        double after = noise(u + step * toU, v + step * toV, variant, 2.3);
        return 0.75 * (u * toU + v * toV) - 0.55 * (after - before) / (2 * step);
    }

    /** Returns the sum of three octaves of noise, from 0 to 1. */
    private static double noise(double u, double v, int variant, double frequency) {
        SeededNoise noise = new SeededNoise(7 + variant);
        double sum = 0;
        double weight = 0.57;
        double scale = frequency;
        for (int octave = 0; octave < 3; octave++) {
            sum += weight * noise.at(scale * u + 31, scale * v + 17, octave);
            weight *= 0.5;
            scale *= 2.1;
        }
        return sum;
    }

    /** A round cloud whose edge is eaten by noise; its middle is the thickest. */
    private static double billow(double u, double v, int variant) {
        double lobes = noise(u, v, variant, 2.3);
        double radius = Math.sqrt(u * u + v * v) * (0.86 + 0.62 * (lobes - 0.25));
        double left = Math.max(0, 1 - radius);
        double body = left * left * (3 - 2 * left);
        return body * (0.55 + 0.75 * lobes) * edge(u, v);
    }

    /** A heap of balls whose edges are eaten by noise, on a nearly flat base. */
    private static double cloud(double u, double v, int variant) {
        double lobes = noise(u, v, variant, 3.1) - 0.47;
        double clear = 1;
        for (double[] ball : BALLS) {
            double x = u - ball[0];
            double y = (v - ball[1]) * (v < ball[1] ? 1.5 : 1);
            double left = 1 - Math.sqrt(x * x + y * y) / ball[2] - 1.1 * lobes;
            clear *= 1 - 0.75 * Math.min(1, Math.max(0, 1.5 * left));
        }
        return (1 - clear) * edge(u, v);
    }

    /** A drop, round below and pointed above, with threads along it. */
    private static double tongue(double u, double v, int variant) {
        double up = 0.5 + 0.5 * v;
        double wave = noise(0, v, variant + 40, 1.6) - 0.47;
        double width = 0.20 + 0.62 * Math.sqrt(Math.max(0, 1 - up)) * Math.min(1, 3.2 * up + 0.2);
        double across = (u - 0.9 * wave * up) / width;
        double body = Math.max(0, 1 - across * across);
        double threads = noise(1.4 * u, 0.55 * v, variant, 2.6);
        double ends = Math.min(1, 2.6 * up) * Math.min(1, 1.5 * (1 - up));
        return body * body * ends * (0.35 + 1.25 * threads) * edge(u, v);
    }

    private static double edge(double u, double v) {
        double x = Math.min(1, 6 * (1 - Math.abs(u)));
        double y = Math.min(1, 6 * (1 - Math.abs(v)));
        return Math.max(0, x) * Math.max(0, y);
    }
}
