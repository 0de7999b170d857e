package nephele.lab.art;

/** A display colour, sRGB components 0–1. */
record Colour(double red, double green, double blue) {
    /** Returns the colour {@code 0xRRGGBB}. */
    static Colour of(int hex) {
        return new Colour((hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0);
    }

    Colour mix(Colour other, double share) {
        return new Colour(
                red + (other.red - red) * share,
                green + (other.green - green) * share,
                blue + (other.blue - blue) * share);
    }

    Colour times(double factor) {
        return new Colour(red * factor, green * factor, blue * factor);
    }

    int rgb() {
        return code(red) << 16 | code(green) << 8 | code(blue);
    }

    static int code(double component) {
        return (int) Math.max(0, Math.min(255, Math.floor(component * 255 + 0.5)));
    }
}
