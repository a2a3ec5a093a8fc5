#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a recording for `mirocup identify` (labs/docs/pitches.md): a camera above the pitch, OpenCV, and a marker on each robot."""
import json
import math
import time

import cv2

MM = 0.0021  # m for each pixel, from the length of the field


def last_sent():
    """The wheel speeds that were sent last, rad/s, as [[left, right], …]: the part that only you can write."""
    raise NotImplementedError


markers = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50))
camera = cv2.VideoCapture(0)
start = time.monotonic()
with open("ours.jsonl", "w", encoding="utf-8") as file:
    print('{"schema": "mirocup/recording/1", "period": null, "robots": 3, "pitch": null}', file=file)
    while time.monotonic() - start < 60.0:
        t, (_, picture) = time.monotonic() - start, camera.read()
        middle = (picture.shape[1] / 2, picture.shape[0] / 2)
        place = lambda p: [float(p[0] - middle[0]) * MM, float(middle[1] - p[1]) * MM]
        robots = [None] * 3
        for corners, number in zip(*markers.detectMarkers(picture)[:2]):
            a, b = place(corners[0].mean(0)), place(corners[0][:2].mean(0))  # centre, front
            robots[int(number[0])] = a + [math.atan2(b[1] - a[1], b[0] - a[0])]
        orange = cv2.moments(cv2.inRange(cv2.cvtColor(picture, cv2.COLOR_BGR2HSV), (5, 120, 120), (20, 255, 255)))
        ball = place((orange["m10"] / orange["m00"], orange["m01"] / orange["m00"])) if orange["m00"] > 2000 else None
        print(json.dumps({"t": t, "ball": ball, "blue": robots, "yellow": [], "commands": {"blue": last_sent()}}), file=file)
