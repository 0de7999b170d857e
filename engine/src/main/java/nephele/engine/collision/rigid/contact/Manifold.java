package nephele.engine.collision.rigid.contact;

/**
 * The contact of two shapes, or one about to happen: up to four points with one normal, which points from the second
 * shape to the first. Points are relative to the first shape's centre, half-way between the surfaces. Reused for every
 * pair.
 */
public final class Manifold {
    public static final int MOST = 4;

    public double nX;
    public double nY;
    public double nZ;
    public int count;
    /** Identifier of the touching faces or edges, 8 bits. */
    public int code;

    public final double[] point = new double[3 * MOST];
    /** Distance between the surfaces in metres, negative when they overlap. */
    public final double[] separation = new double[MOST];
    /** Identifier of each point, 8 bits, constant while the point persists. */
    final int[] feature = new int[MOST];

    void clear() {
        count = 0;
    }

    void normal(double x, double y, double z) {
        nX = x;
        nY = y;
        nZ = z;
    }

    void add(double x, double y, double z, double metres, int id) {
        point[3 * count] = x;
        point[3 * count + 1] = y;
        point[3 * count + 2] = z;
        separation[count] = metres;
        feature[count] = id & 0xff;
        count++;
    }

    /** Removes a point; the last one replaces it. */
    public void remove(int index) {
        count--;
        if (index < count) {
            System.arraycopy(point, 3 * count, point, 3 * index, 3);
            separation[index] = separation[count];
            feature[index] = feature[count];
        }
    }

    public int features() {
        int packed = 0;
        for (int i = 0; i < count; i++) {
            packed |= feature[i] << (8 * i);
        }
        return packed;
    }

    /** Exchanges the two shapes: {@code dX}, y, z is the first one's centre minus the second's. */
    void swap(double dX, double dY, double dZ) {
        normal(-nX, -nY, -nZ);
        for (int i = 0; i < count; i++) {
            point[3 * i] += dX;
            point[3 * i + 1] += dY;
            point[3 * i + 2] += dZ;
        }
    }
}
