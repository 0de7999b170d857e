package nephele.engine.particle;

/** One particle at one time. A law writes all of it; one object serves all particles. */
final class ParticleState {
    /** The place in metres from the emitter's centre. */
    double x;

    double y;
    double z;
    double halfWidth;
    /** What the square is stretched by along a direction of the world, in metres to either side. */
    double alongX;

    double alongY;
    double alongZ;
    /** The fraction of the light behind that the middle of the particle takes away. */
    double opacity;
    /** The fraction of the light on it that is scattered. */
    double albedo;
    /** The radiance of the middle that the particle itself adds. */
    double red;

    double green;
    double blue;
    /** See {@link ParticlePicture#number}. */
    int picture;

    /** Rotation of the picture, in turns. */
    double turns;

    void place(double atX, double atY, double atZ) {
        x = atX;
        y = atY;
        z = atZ;
    }

    void stretch(double byX, double byY, double byZ) {
        alongX = byX;
        alongY = byY;
        alongZ = byZ;
    }

    void emission(double r, double g, double b, double factor) {
        red = Math.max(0, r * factor);
        green = Math.max(0, g * factor);
        blue = Math.max(0, b * factor);
    }
}
