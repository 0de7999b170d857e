flat in float weight;

layout(location = 0) out float added;

void main() {
    added = weight;
}
