package nephele.engine.scene.light;

import nephele.engine.math.TriangleMeeting;

/** Something that a half-line may meet. */
sealed interface Occluder {
    /** Whether it meets o + t · d, 0 ≤ t ≤ {@code length}. */
    boolean meets(double[] o, double[] d, double length);

    /** Whether a point is inside it or on its surface; nothing is inside a surface that is not closed. */
    boolean holds(double[] p);

    /** What lies behind all planes, four numbers each: exact at edges, so that touching solids leave no gap. */
    record Convex(double[] planes) implements Occluder {
        /** Clips by every plane (Cyrus and Beck 1978); what is left lies inside. */
        @Override
        public boolean meets(double[] o, double[] d, double length) {
            double enter = 0;
            double leave = length;
            for (int i = 0; i < planes.length; i += 4) {
                double along = planes[i] * d[0] + planes[i + 1] * d[1] + planes[i + 2] * d[2];
                double distance = planes[i + 3] - planes[i] * o[0] - planes[i + 1] * o[1] - planes[i + 2] * o[2];
                if (along > 0) {
                    leave = Math.min(leave, distance / along);
                } else if (along < 0) {
                    enter = Math.max(enter, distance / along);
                } else if (distance < 0) {
                    return false;
                }
                if (enter > leave) {
                    return false;
                }
            }
            return true;
        }

        @Override
        public boolean holds(double[] p) {
            for (int i = 0; i < planes.length; i += 4) {
                if (planes[i] * p[0] + planes[i + 1] * p[1] + planes[i + 2] * p[2] > planes[i + 3]) {
                    return false;
                }
            }
            return true;
        }
    }

    /** A triangle of a mesh that is not convex: nine numbers from {@code at} on. */
    record Triangle(double[] corners, int at) implements Occluder {
        @Override
        public boolean meets(double[] o, double[] d, double length) {
            double t = TriangleMeeting.parameter(o[0], o[1], o[2], d[0], d[1], d[2], corners, at);
            return t >= 0 && t <= length;
        }

        @Override
        public boolean holds(double[] p) {
            return false;
        }
    }
}
