package nephele.workshop.art.sprite;

/** A colour as stored, 0 to 1. */
record Tint(double red, double green, double blue) {
    static Tint of(int rgb) {
        return new Tint((rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
    }

    Tint towards(Tint other, double share) {
        return new Tint(
                red + (other.red - red) * share,
                green + (other.green - green) * share,
                blue + (other.blue - blue) * share);
    }

    Tint times(double factor) {
        return new Tint(red * factor, green * factor, blue * factor);
    }
}
