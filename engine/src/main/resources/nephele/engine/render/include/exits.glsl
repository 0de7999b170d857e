// The exits of the level. EXITS is their number.
uniform vec4 feetAndRadius[EXITS]; // the base's centre relative to the eye
uniform float heightMetres[EXITS];
