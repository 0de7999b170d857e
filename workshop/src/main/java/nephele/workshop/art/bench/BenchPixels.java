package nephele.workshop.art.bench;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.Pixels;

/** The pictures of the benchmark scenes, equal in every pixel to those of the compared engines. */
public final class BenchPixels {
    static final int BOX_SIDE = 256;
    static final int SKY_SIDE = 512;
    static final int GROUND_SIDE = 512;
    static final int TREE_SIDE = 64;

    /** Base colours of the faces +x, −x, +y, −y, +z, −z. */
    private static final int[][] SKY_BASE = {
        {200, 120, 120}, {120, 200, 120}, {120, 120, 220}, {200, 200, 120}, {200, 120, 200}, {120, 200, 200}
    };

    private BenchPixels() {}

    /** Paints a dark frame around a two-tone chequer, with a little noise. */
    public static BufferedImage box() {
        return Pixels.picture(BOX_SIDE, BOX_SIDE, BenchPixels::boxPixel);
    }

    private static int boxPixel(int x, int y) {
        int grain = (int) (random(x, y, 1) * 40) / 2;
        boolean frame = x < 8 || y < 8 || x >= BOX_SIDE - 8 || y >= BOX_SIDE - 8;
        boolean light = ((x / 32) + (y / 32)) % 2 == 0;
        int red = frame ? 60 : light ? 200 : 150;
        int green = frame ? 40 : light ? 150 : 100;
        int blue = frame ? 20 : 60;
        return rgb(red + grain, green + grain, blue + grain);
    }

    /** Paints face {@code face} of the skybox in the order +x, −x, +y, −y, +z, −z: tinted noise under a grid. */
    public static BufferedImage sky(int face) {
        int[] base = SKY_BASE[face];
        return Pixels.picture(SKY_SIDE, SKY_SIDE, (x, y) -> {
            int line = x % 64 == 0 || y % 64 == 0 ? -40 : 0;
            int add = (int) (noise(x / 64f, y / 64f, 10 + face) * 70) - 20 + line;
            return rgb(base[0] + add, base[1] + add, base[2] + add);
        });
    }

    /** Paints the ground: two sizes of green noise. */
    public static BufferedImage ground() {
        return Pixels.picture(GROUND_SIDE, GROUND_SIDE, (x, y) -> {
            int add = (int) (random(x, y, 2) * 50 + random(x / 8, y / 8, 3) * 40);
            return rgb(60 + add, 110 + add, 40 + add / 2);
        });
    }

    /** Paints a tree with straight alpha. */
    public static BufferedImage tree() {
        BufferedImage picture = new BufferedImage(TREE_SIDE, TREE_SIDE, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < TREE_SIDE; y++) {
            for (int x = 0; x < TREE_SIDE; x++) {
                picture.setRGB(x, TREE_SIDE - 1 - y, treePixel(x, y));
            }
        }
        return picture;
    }

    /** @param y from the lower edge */
    private static int treePixel(int x, int y) {
        int grain = (int) (random(x, y, 4) * 60);
        float dx = (x - 31.5f) / 26f;
        float dy = (y - 40f) / 22f;
        float r = dx * dx + dy * dy + (random(x / 3, y / 3, 5) - 0.5f) * 0.3f;
        if (r < 1) {
            return (int) Math.min(255, (1 - r) * 700) << 24 | rgb(30 + grain, 100 + grain, 30 + grain / 2);
        }
        boolean isTrunk = Math.abs(x - 31.5f) < 4 && y < 24;
        return isTrunk ? 0xff000000 | rgb(90 + grain / 2, 60 + grain / 2, 30) : rgb(40, 110, 40);
    }

    private static int rgb(int red, int green, int blue) {
        return clamp(red) << 16 | clamp(green) << 8 | clamp(blue);
    }

    private static int clamp(int value) {
        return Math.max(0, Math.min(255, value));
    }

    private static int hash(int x, int y, int seed) {
        int h = x * 374761393 + y * 668265263 + seed * 1274126177;
        h = (h ^ (h >>> 13)) * 1274126177;
        return h ^ (h >>> 16);
    }

    static float random(int x, int y, int seed) {
        return (hash(x, y, seed) & 0xffffff) / (float) 0x1000000;
    }

    /** Returns smooth noise of one octave, 0 to 1. */
    static float noise(float x, float y, int seed) {
        int column = (int) Math.floor(x);
        int row = (int) Math.floor(y);
        float right = ease(x - column);
        float down = ease(y - row);
        float a = random(column, row, seed);
        float b = random(column + 1, row, seed);
        float c = random(column, row + 1, seed);
        float d = random(column + 1, row + 1, seed);
        return (a + (b - a) * right) * (1 - down) + (c + (d - c) * right) * down;
    }

    private static float ease(float t) {
        return t * t * (3 - 2 * t);
    }
}
