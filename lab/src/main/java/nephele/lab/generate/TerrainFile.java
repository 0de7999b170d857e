package nephele.lab.generate;

import nephele.engine.asset.HeightMap;
import nephele.engine.asset.HeightMapFile;

/** Writes heights as a grey PNG of 16 bits. */
public final class TerrainFile {
    private TerrainFile() {}

    /**
     * Returns the file of square heights.
     *
     * @param heights 0 to 1, row by row
     */
    public static byte[] png(float[] heights, int side) {
        short[] values = new short[side * side];
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) Math.round(HeightMap.FULL_SCALE * Math.max(0, Math.min(1, heights[i])));
        }
        return HeightMapFile.png(new HeightMap(side, side, 16, values));
    }
}
